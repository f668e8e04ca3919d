// SPDX-License-Identifier: Apache-2.0
#include "mcap/recovery.hpp"

#include <map>
#include <set>
#include <utility>

#include "scan.hpp"

namespace tocsin::mcap {
namespace {

class Recovery final : public ScanVisitor {
 public:
  explicit Recovery(Writer& writer) : writer_(writer) {}

  Recovered result;

  void on_schema(Schema&& schema) override { (void)writer_.adopt(std::move(schema)); }
  void on_channel(Channel&& channel) override {
    // Its schema may have been in a chunk that is damaged; the bytes of its messages are sound.
    const std::uint16_t id = channel.id;
    Channel without_schema = channel;
    without_schema.schema_id = 0;
    if (channels_.count(id) != 0) return;
    if (!writer_.adopt(std::move(channel)) && !writer_.adopt(std::move(without_schema))) return;
    channels_.insert(id);
  }
  void on_message(const Place&, const Message& message) override {
    if (channels_.count(message.channel_id) == 0) {
      ++result.damage.messages;
    } else {
      (void)writer_.write(message);
    }
  }
  void on_chunk(const Place&, const LoadedChunk& chunk) override {
    ReadyChunk ready{chunk.head.compression,
                     chunk.head.uncompressed_size,
                     chunk.head.uncompressed_crc,
                     chunk.compressed,
                     {}};
    bool all_known = true;
    for_each_record(chunk.records, [&](Opcode opcode, Span content, std::size_t offset) {
      if (opcode != Opcode::message) {
        show_declaration(*this, opcode, content);
        return;
      }
      const auto message = decode<Message>(content);
      all_known = all_known && message && channels_.count(message->channel_id) != 0;
      if (all_known) ready.entries.push_back({message->channel_id, message->log_time_ns, offset});
    });
    if (chunk.state != LoadedChunk::State::whole || !all_known) {
      copy_messages(chunk.records);
    } else if (!ready.entries.empty()) {
      (void)writer_.write(ready);
    }
  }
  void on_attachment(const Place&, Attachment&& attachment) override {
    if (writer_.write(attachment) == Kept::all) ++result.attachments;
  }
  void on_metadata(const Place&, Metadata&& metadata) override {
    if (writer_.write(metadata) == Kept::all) ++result.metadata;
  }

 private:
  void copy_messages(Span records) {
    for_each_record(records, [this](Opcode opcode, Span content, std::size_t) {
      const auto message = opcode == Opcode::message ? decode<Message>(content) : std::nullopt;
      if (message) on_message({}, *message);
    });
  }

  Writer& writer_;
  std::set<std::uint16_t> channels_;
};

}  // namespace

Header header_of(ByteSource& source, const std::string& name) { return read_header(source, name); }

Recovered recover(ByteSource& source, Writer& writer) {
  Recovery recovery(writer);
  const std::uint64_t lost_before = writer.lost();
  const std::uint64_t kept_before = writer.statistics().message_count;
  Damage damage = scan(source, recovery);
  damage.messages = recovery.result.damage.messages;
  recovery.result.damage = damage;
  (void)writer.flush();
  recovery.result.messages = writer.statistics().message_count - kept_before;
  recovery.result.lost = writer.lost() - lost_before;
  return recovery.result;
}

}  // namespace tocsin::mcap
