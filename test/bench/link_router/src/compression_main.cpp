// SPDX-License-Identifier: Apache-2.0
// What compression leaves of the topics of a bag on the air: each message as it was recorded,
// through both routers' decisions, over a link that loses each packet by itself, both ways, and
// takes 20 ms. usage: link_compression BAG [TOPIC...]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "bag/bag_reader.hpp"
#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "link_router/compressed_samples.hpp"
#include "router_radio.hpp"
#include "runtime/middleware/sample_codec.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;
using Bytes = SampleCodec::Bytes;
using Clock = std::chrono::steady_clock;

constexpr Time begin{std::chrono::hours(1)};

struct Recorded {
  Time at;
  std::uint64_t writer;
  std::shared_ptr<const Bytes> bytes;
};
using Topics = std::map<std::string, std::vector<Recorded>>;

/// What the codec costs.
struct Work {
  double seconds = 0;
  std::size_t samples = 0;
  template <class Call>
  auto time(const Call& call) {
    const auto from = Clock::now();
    auto result = call();
    seconds += std::chrono::duration<double>(Clock::now() - from).count();
    ++samples;
    return result;
  }
};

const Bytes& content(const router::Sample& sample) {
  return *static_cast<const Bytes*>(sample.content.get());
}

/// One topic over the link.
class TopicRun {
 public:
  TopicRun(const std::vector<Recorded>& messages, double loss, bool compressed)
      : messages_(messages),
        channel_(lossy_channel(loss, 0.02), {}, 1, begin),
        routers_(channel_, {}, begin) {
    router::StreamRule rule = stream_rule("topic", TrafficClass::high);
    rule.compressed = compressed;
    routers_.add_stream(0, 1, rule, begin);
    routers_.sender(0).set_compress(
        [this](const auto& plain, const auto* base) { return smaller(plain, base); });
    routers_.set_usable([this](const auto& one) { return restore(one.sample); });
  }

  void run() {
    const auto deliver = [this](std::size_t, router::StreamId, const router::Origin&, Time) {
      ++delivered_;
    };
    const Time end = messages_.back().at + std::chrono::seconds(1);
    std::size_t next_message = 0;
    std::map<std::uint64_t, std::uint64_t> sequences;
    for (Time now = begin; now < end;) {
      while (next_message < messages_.size() && messages_[next_message].at <= now) {
        const Recorded& one = messages_[next_message++];
        const router::Origin origin{one.writer, ++sequences[one.writer], now};
        routers_.sender(0).offer(1, {origin, one.bytes->size(), one.bytes, {}}, now);
      }
      routers_.serve(now);
      const Time message = next_message < messages_.size() ? messages_[next_message].at : end;
      now = std::max(std::min({message, routers_.next_event(now), end}), now + Duration{1});
      routers_.advance(now, deliver);
    }
  }

  [[nodiscard]] std::size_t air_bytes() const { return routers_.bytes_of(1); }
  [[nodiscard]] std::size_t delivered() const { return delivered_; }
  [[nodiscard]] const Work& compression() const { return compression_; }
  [[nodiscard]] const Work& restoring() const { return restoring_; }

 private:
  std::optional<router::Sample> smaller(const router::Sample& plain, const router::Sample* base) {
    auto bytes = compression_.time([&] {
      return codec_.compress(content(plain), base != nullptr ? content(*base) : Bytes{});
    });
    const auto coding =
        compressed_by(plain.origin.sequence,
                      base != nullptr ? std::optional(base->origin.sequence) : std::nullopt);
    if (!coding) return std::nullopt;
    originals_[{plain.origin.source, plain.origin.sequence}] = plain.content;
    const std::size_t size = bytes.size();
    return router::Sample{plain.origin, size, std::make_shared<const Bytes>(std::move(bytes)),
                          *coding};
  }
  /// As LinkEvents of the router has it.
  bool restore(const router::Sample& sample) {
    if (!sample.coding.is_compressed) return true;
    const auto& origin = sample.origin;
    const router::Sample* base = nullptr;
    if (sample.coding.base > 0) {
      base = kept_.find(1, origin.source, origin.sequence - sample.coding.base);
      if (base == nullptr) return false;
    }
    auto plain = restoring_.time([&] {
      return codec_.restore(content(sample), base != nullptr ? content(*base) : Bytes{});
    });
    if (!plain) return false;
    if (*plain != *static_cast<const Bytes*>(originals_[{origin.source, origin.sequence}].get())) {
      throw EnvironmentError("a message is not what was written");
    }
    const std::size_t size = plain->size();
    kept_.add(1, {origin, size, std::make_shared<const Bytes>(std::move(*plain)), {}});
    return true;
  }

  const std::vector<Recorded>& messages_;
  radio::RadioChannel channel_;
  RouterRadio routers_;
  SampleCodec codec_;
  router::CompressedSamples kept_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::shared_ptr<const void>> originals_;
  Work compression_;
  Work restoring_;
  std::size_t delivered_ = 0;
};

Topics read(const std::string& path, const std::vector<std::string>& wanted) {
  bag::BagReader bag(path);
  bag::Selection selection;
  selection.wanted = [&](const bag::Topic& topic) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), topic.name) != wanted.end();
  };
  Topics topics;
  const auto stream = bag.messages(selection);
  std::optional<std::int64_t> first_ns;
  while (const auto one = stream->next()) {
    const std::int64_t log_ns = one->message.log_time_ns;
    if (!first_ns) first_ns = log_ns;
    topics[bag.topics()[one->topic].topic.name].push_back(
        {begin + Duration(log_ns - *first_ns), one->message.writer,
         std::make_shared<const Bytes>(one->message.data, one->message.data + one->message.size)});
  }
  if (topics.empty()) throw ConfigError(path + ": has no message of these topics");
  return topics;
}

double mean(double sum, std::size_t count) {
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

void print(const std::string& topic, const std::vector<Recorded>& messages, double loss) {
  TopicRun plain(messages, loss, false);
  TopicRun small(messages, loss, true);
  plain.run();
  small.run();
  std::size_t bytes = 0;
  for (const Recorded& one : messages) bytes += one.bytes->size();
  const auto count = messages.size();
  std::printf("%-28s %6zu %7.0f %9.0f %9.0f %7.2f %6.1f %6.1f %7.1f %7.1f\n", topic.c_str(), count,
              mean(static_cast<double>(bytes), count),
              mean(static_cast<double>(plain.air_bytes()), count),
              mean(static_cast<double>(small.air_bytes()), count),
              static_cast<double>(small.air_bytes()) / static_cast<double>(plain.air_bytes()),
              100 * mean(static_cast<double>(plain.delivered()), count),
              100 * mean(static_cast<double>(small.delivered()), count),
              mean(1e6 * small.compression().seconds, small.compression().samples),
              mean(1e6 * small.restoring().seconds, small.restoring().samples));
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("link_compression", [&] {
    if (argc < 2) throw ConfigError("usage: link_compression BAG [TOPIC...]");
    const Topics topics = read(argv[1], {argv + 2, argv + argc});
    for (const double loss : {0.0, 0.1}) {
      std::printf("each packet lost at %.0f %%\n", 100 * loss);
      std::printf("%-28s %6s %7s %9s %9s %7s %6s %6s %7s %7s\n", "topic", "count", "bytes", "air",
                  "air, new", "ratio", "come %", "new %", "us/comp", "us/rest");
      for (const auto& [topic, messages] : topics) print(topic, messages, loss);
    }
    return 0;
  });
}
