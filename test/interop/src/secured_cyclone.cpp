// SPDX-License-Identifier: Apache-2.0
#include "secured_cyclone.hpp"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "cyclone.hpp"
#include "geometry_msgs.h"
#include "keystore/enclave.hpp"
#include "tocsin_msgs.h"

namespace tocsin::interop {
namespace {

using Qos = CycloneParticipant::Qos;

constexpr auto write_period = std::chrono::milliseconds(5);

/// On that interface only, where it looks for our routers, too.
void set_network(const std::string& address) {
  const std::string settings =
      "<General><Interfaces><NetworkInterface address='" + address +
      "'/></Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery><Peers>"
      "<Peer address='" +
      address + "'/></Peers></Discovery>";
  ::setenv("CYCLONEDDS_URI", settings.c_str(), 1);
}

void set_plugin(const Qos& qos, const std::string& kind, const std::string& library,
                const std::string& functions) {
  const std::string prefix = "dds.sec." + kind + ".library";
  dds_qset_prop(qos.get(), (prefix + ".path").c_str(), library.c_str());
  dds_qset_prop(qos.get(), (prefix + ".init").c_str(), ("init_" + functions).c_str());
  dds_qset_prop(qos.get(), (prefix + ".finalize").c_str(), ("finalize_" + functions).c_str());
}

/// DDS Security 1.1 with Cyclone's plug-ins and the files of an enclave.
Qos identity(const std::string& enclave) {
  Qos qos = CycloneParticipant::qos();
  if (enclave.empty()) return qos;
  set_plugin(qos, "auth", CYCLONE_AUTH, "authentication");
  set_plugin(qos, "crypto", CYCLONE_CRYPTO, "crypto");
  set_plugin(qos, "access", CYCLONE_ACCESS, "access_control");
  const auto set_file = [&](const char* name, const char* file) {
    dds_qset_prop(qos.get(), name, ("file:" + enclave + "/" + file).c_str());
  };
  set_file("dds.sec.auth.identity_ca", keystore::enclave_file::identity_ca);
  set_file("dds.sec.auth.identity_certificate", keystore::enclave_file::certificate);
  set_file("dds.sec.auth.private_key", keystore::enclave_file::key);
  set_file("dds.sec.access.permissions_ca", keystore::enclave_file::permissions_ca);
  set_file("dds.sec.access.governance", keystore::enclave_file::governance);
  set_file("dds.sec.access.permissions", keystore::enclave_file::permissions);
  if (std::filesystem::exists(enclave + "/" + keystore::enclave_file::revocations)) {
    set_file("org.eclipse.cyclonedds.sec.auth.crl", keystore::enclave_file::revocations);
  }
  return qos;
}

/// How many samples can be taken of a reader now.
std::size_t take_all(dds_entity_t reader) {
  std::size_t taken = 0;
  interop::take_all<char>(reader, [&taken](const char&) { ++taken; });
  return taken;
}

/// A writer of a topic, when it may have one, and a reader.
class Ends {
 public:
  Ends(const CycloneParticipant& participant, const dds_topic_descriptor_t& type,
       const std::string& name, const std::string& type_name) {
    const Qos qos = CycloneParticipant::qos();
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_BEST_EFFORT, 0);
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 64);
    dds_qset_ignorelocal(qos.get(), DDS_IGNORELOCAL_PARTICIPANT);
    const dds_entity_t topic = participant.topic(type, name, type_name);
    // Cyclone's own plug-in refuses what the identity's permissions do not have.
    writer_ = dds_create_writer(participant.entity(), topic, qos.get(), nullptr);
    reader_ = dds_create_reader(participant.entity(), topic, qos.get(), nullptr);
  }
  void write(const void* message) const {
    if (writer_ > 0) (void)dds_write(writer_, message);
  }
  [[nodiscard]] std::size_t take() const { return reader_ > 0 ? take_all(reader_) : 0; }

 private:
  dds_entity_t writer_ = 0;
  dds_entity_t reader_ = 0;
};

}  // namespace

std::size_t speak_as_cyclone(const CycloneIdentity& who, const std::string& mark,
                             std::chrono::milliseconds time) {
  set_network(who.address);
  const CycloneParticipant participant(who.domain, identity(who.enclave));
  const Ends location(participant, geometry_msgs_msg_PoseWithCovarianceStamped_desc, "rt/location",
                      "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_");
  const Ends goal(participant, tocsin_msgs_msg_Goal_desc, "rt/goal",
                  "tocsin_msgs::msg::dds_::Goal_");
  std::string text = mark;
  geometry_msgs_msg_PoseWithCovarianceStamped place{};
  place.header.frame_id = text.data();
  tocsin_msgs_msg_Goal order{};
  std::memcpy(&order.mission, mark.data(), std::min(mark.size(), sizeof order.mission));
  std::size_t taken = 0;
  for (const auto end = std::chrono::steady_clock::now() + time;
       std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(write_period)) {
    location.write(&place);
    goal.write(&order);
    taken += location.take() + goal.take();
  }
  return taken;
}

}  // namespace tocsin::interop
