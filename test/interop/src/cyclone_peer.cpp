// SPDX-License-Identifier: Apache-2.0
#include "cyclone.hpp"
#include "peer.hpp"
#include "std_msgs.h"

namespace tocsin::interop {
namespace {

class CyclonePeer : public Peer {
 public:
  explicit CyclonePeer(const PeerSettings& settings) : participant_(settings.domain) {
    const dds_entity_t topic =
        participant_.topic(std_msgs_msg_String_desc, topic_on_wire, type_on_wire);
    const auto qos = CycloneParticipant::qos();
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 1000);
    reader_ = participant_.reader(topic, qos);
    if (settings.lifespan_ms > 0) dds_qset_lifespan(qos.get(), DDS_MSECS(settings.lifespan_ms));
    writer_ = participant_.writer(topic, qos);
  }

  void write(const std::string& text) override {
    std_msgs_msg_String message{const_cast<char*>(text.c_str())};
    (void)dds_write(writer_, &message);
  }

  std::vector<HeardText> take() override {
    std::vector<HeardText> texts;
    take_all<std_msgs_msg_String>(reader_, [&](const auto& message) {
      texts.push_back({message.data, now_ms()});
    });
    return texts;
  }

 private:
  CycloneParticipant participant_;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
};

}  // namespace

std::unique_ptr<Peer> make_cyclone_peer(const PeerSettings& settings) {
  return std::make_unique<CyclonePeer>(settings);
}

}  // namespace tocsin::interop
