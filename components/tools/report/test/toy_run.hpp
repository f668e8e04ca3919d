// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "foundation/temporary_folder.hpp"
#include "table_bag.hpp"

namespace tocsin::report {

/// The folder of a run of 100 s that began at 1000 s, as the recorders write it; removed at the
/// end. The vehicle pauses from 1020 to 1030 s and from 1060 s to the end.
class ToyRun : public TemporaryFolder {
 public:
  ToyRun() {
    write("traffic.yaml",
          "uxv:\n"
          "  critical: {while_poor: send, topics: [transmission_state]}\n"
          "  low: {while_poor: drop, topics: [camera/image]}\n"
          "gcs:\n"
          "  critical: {while_poor: send, topics: [transmission_state]}\n"
          "  high: {while_poor: latest, topics: [goal]}\n");
    write("deployment.yaml", "traffic: " + path("traffic.yaml") + "\nqos: " + path("traffic.yaml") +
                                 "\nhosts: {uxv: {role: uxv, address: 10.77.0.1}}\n");
    write("gcs/messages.csv", head +
                                  "1000.5,1000.0,camera/image,1,1,1000\n"
                                  "1001.5,1001.0,camera/image,1,2,1000\n"
                                  "1004.5,1004.0,camera/image,1,5,1000\n"
                                  "1005.0,1004.9,transmission_state,2,1,50\n"
                                  "1005.2,1005.1,transmission_state,3,1,50\n");
    write("gcs/transmission_state.csv",
          "receive_s,send_s,role\n1005.0,1004.9,uxv\n1005.2,1005.1,gcs\n");
    write("gcs/mission_status.csv",
          "receive_s,send_s,mission,state,waypoint,waypoints,goals_sent,elapsed_s\n"
          "1001,1001,mission_a,running,0,9,1,0\n1100,1100,mission_a,done,8,9,12,99.5\n");
    write("uxv/messages.csv", head + "1002.25,1002.0,goal,4,1,70\n1100,1099.9,goal,4,2,70\n");
    write("uxv/transmission_state.csv",
          "receive_s,send_s,role,active,policy,reason,qni\n"
          "1000,1000,uxv,1,tocp_dsp,steady,90\n1010,1010,gcs,0,tocp_dsp,steady,10\n"
          "1020,1020,uxv,0,tocp_dsp,alarm,30\n1030,1030,uxv,1,tocp_dsp,best_so_far,70\n"
          "1060,1060,uxv,0,tocp_dsp,alarm,\n");
    write("uxv/network_quality.csv",
          "receive_s,send_s,per_percent,signal_dbm\n1000,1000,0,-50\n1020,1020,40,-80\n");
  }
  /// A file of the run; `gcs/TOPIC.csv` becomes messages of that side's bag.
  void write(const std::string& name, const std::string& text) {
    const std::filesystem::path file(name);
    if (file.extension() != ".csv") {
      TemporaryFolder::write(name, text);
      return;
    }
    const std::string side = file.parent_path().string();
    texts_[side][file.stem().string()] = text;
    std::filesystem::remove_all(path(side + "/bag"));
    const TableBag made(path(side), texts_[side]);
  }
  /// Further rows of such a table.
  void append(const std::string& name, const std::string& rows) {
    const std::filesystem::path file(name);
    write(name, texts_[file.parent_path().string()][file.stem().string()] + rows);
  }
  void remove(const std::string& side) {
    texts_.erase(side);
    std::filesystem::remove_all(path(side));
  }

 private:
  std::map<std::string, std::map<std::string, std::string>> texts_;  ///< by side and topic
  const std::string head = "receive_s,send_s,topic,writer,sequence,bytes\n";
};

}  // namespace tocsin::report
