// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "radio_channel/trace.hpp"

namespace tocsin::radio {

/// Everything about a link. Sources of the defaults: tx power and noise (kTB of 20 MHz plus a noise
/// figure of 7 dB) of common adapters; free-space loss at 1 m and 2.437 GHz is 40.2 dB; shadowing
/// and Rician factors as fitted to the CRAWDAD set kth/rss (sigma 5.9 to 10.6 dB with fading,
/// correlation distance 1.5 to 2.5 m, K 0 to 3 dB); correlation exp(-d/dcorr) after Gudmundson
/// 1991.
struct ChannelParams {
  std::string mode = "radio";
  double access_point_x_m = 0;
  double access_point_y_m = 0;
  double tx_dbm = 16;
  double loss_at_1m_db = 40.2;
  double exponent_near = 2.0;
  double exponent_far = 2.8;
  double breakpoint_m = 5;
  double shadowing_sigma_db = 5;
  double shadowing_distance_m = 2;
  double shared_shadowing = 1;
  double rician_k_clear_db = 6;
  double rician_k_walled_db = 3;
  double environment_doppler_hz = 1;
  double frequency_mhz = 2437;
  double noise_dbm = -94;
  double snr_offset_db = 0;
  std::string data_rate = "adaptive";
  int attempts = 7;
  bool access_categories = false;
  int queue_frames = 100;
  double frame_lifetime_s = 0;
  double wire_delay_s = 0.0003;
  double background_load = 0;
  int background_stations = 3;
  double background_frame_s = 0.0005;
  double loss = 0;
  double delay_s = 0.001;
  double jitter_s = 0;
  double rate_mbit_s = 0;
  double good_loss = 0.01;
  double bad_loss = 0.4;
  double good_s = 20;
  double bad_s = 5;
  std::vector<double> outages_s;
  std::string trace_file;
  bool trace_random_start = true;
  std::shared_ptr<const Trace> trace;  ///< what load_channel read from trace_file

  template <class Visitor>
  void visit(Visitor& v) {
    v("mode", mode, {"radio", "bernoulli", "gilbert_elliott"}, "model; the last two have no MAC");
    visit_propagation(v);
    visit_mac(v);
    v("loss", loss, {0, 1}, "[1] bernoulli: probability that a packet is lost");
    v("delay_s", delay_s, {0, 10}, "[s] one-way delay without MAC");
    v("jitter_s", jitter_s, {0, 10}, "[s] without MAC: up to so much more or less, in order");
    v("rate_mbit_s", rate_mbit_s, {0, 1e5},
      "[Mbit/s] without MAC: what each way carries, where queue_frames wait at most; 0: all");
    v("good_loss", good_loss, {0, 1}, "[1] gilbert_elliott: loss in the good state");
    v("bad_loss", bad_loss, {0, 1}, "[1] gilbert_elliott: loss in the bad state");
    v("good_s", good_s, {0.001, 1e6}, "[s] gilbert_elliott: mean stay in the good state");
    v("bad_s", bad_s, {0.001, 1e6}, "[s] gilbert_elliott: mean stay in the bad state");
    v("outages_s", outages_s, {0, 1e9}, "[s] dead intervals from the start: begin, length, ...");
    v("trace_file", trace_file,
      "radio: measured link in place of path loss and shadowing; CSV, relative to this file");
    v("trace_random_start", trace_random_start, "whether the seed decides where the trace begins");
  }

 private:
  template <class Visitor>
  void visit_propagation(Visitor& v) {
    v("access_point_x_m", access_point_x_m, {-1e5, 1e5}, "[m] access point in the map frame");
    v("access_point_y_m", access_point_y_m, {-1e5, 1e5}, "[m] access point in the map frame");
    v("tx_dbm", tx_dbm, {-50, 40}, "[dBm] transmit power of both stations with antenna gains");
    v("loss_at_1m_db", loss_at_1m_db, {0, 100}, "[dB] path loss at 1 m");
    v("exponent_near", exponent_near, {0, 8}, "[1] path loss exponent up to the breakpoint");
    v("exponent_far", exponent_far, {0, 8}, "[1] path loss exponent beyond the breakpoint");
    v("breakpoint_m", breakpoint_m, {1, 1e5}, "[m] distance at which the exponent changes");
    v("shadowing_sigma_db", shadowing_sigma_db, {0, 30}, "[dB] standard deviation of shadowing");
    v("shadowing_distance_m", shadowing_distance_m, {0.1, 1000}, "[m] correlation 1/e at");
    v("shared_shadowing", shared_shadowing, {0, 1},
      "[1] below 1: another radio of the site, which shares so much of the variance of the first "
      "one's shadowing, and nothing else that is drawn");
    v("rician_k_clear_db", rician_k_clear_db, {-20, 60}, "[dB] direct over scattered, no wall");
    v("rician_k_walled_db", rician_k_walled_db, {-20, 60}, "[dB] the same behind a wall");
    v("environment_doppler_hz", environment_doppler_hz, {0, 100}, "[Hz] people moving around");
    v("frequency_mhz", frequency_mhz, {100, 100000}, "[MHz] carrier");
    v("noise_dbm", noise_dbm, {-120, 0}, "[dBm] noise in the channel at both receivers");
    v("snr_offset_db", snr_offset_db, {-20, 20}, "[dB] receivers better than the NIST model");
  }

  template <class Visitor>
  void visit_mac(Visitor& v) {
    v("data_rate", data_rate, {"adaptive", "6", "9", "12", "18", "24", "36", "48", "54"},
      "[Mbit/s] of unicast frames; adaptive: what the rate control chooses for each attempt");
    v("attempts", attempts, {1, 31}, "[1] transmissions of a unicast frame before it is given up");
    v("access_categories", access_categories,
      "whether urgent packets go first: 802.11e queues of voice, video, best effort, background");
    v("queue_frames", queue_frames, {1, 100000}, "[1] frames per queue, then tail drop");
    v("frame_lifetime_s", frame_lifetime_s, {0, 100},
      "[s] a frame that has waited longer is given up (dot11EDCATableMSDULifetime); 0: never");
    v("wire_delay_s", wire_delay_s, {0, 10}, "[s] one way between access point and ground station");
    v("background_load", background_load, {0, 0.95}, "[1] share of time taken by other stations");
    v("background_stations", background_stations, {1, 100}, "[1] stations that make that load");
    v("background_frame_s", background_frame_s, {0.0001, 0.01}, "[s] air time of their frames");
  }
};

}  // namespace tocsin::radio
