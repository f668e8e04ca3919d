// SPDX-License-Identifier: Apache-2.0
// Files that users write, broken in all ways: each is read, or refused in one printable line,
// within bounded memory.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "../src/files_target.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr int mutations_of_a_kind = 400;
constexpr rlim_t most_memory = rlim_t{1} << 30U;  // [byte] of address space

const std::vector<std::string> words{
    "&x [*x]", "*x",    "&x",        "[[[[[",  "]",        "{",     "}",        "{}",
    "~",       "1e308", "-1",        "0",      ".nan",     "-.inf", "1e-300",   "99999999999",
    "0x7f",    "true",  "\x1b[2J",   "\xff",   "\"",       "'",     "|\n",      "? ",
    ": ",      "- ",    "\t",        "<<: *x", "${share}", "${",    "../../..", "/dev/zero",
    "#",       "---\n", "!!binary ", "x: y"};

/// Changes of a text at random places.
class Mutation {
 public:
  explicit Mutation(unsigned seed) : random_(seed) {}

  std::string of(std::string text) {
    for (std::size_t i = 1 + below(4); i > 0; --i) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  const std::string& word() { return words[below(words.size())]; }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    switch (below(6)) {
      case 0:
        text.insert(at, word());
        break;
      case 1:
        text.erase(at, below(20));
        break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        break;
      case 3:
        replace(text, at, ": ", word());
        break;
      case 4:
        replace(text, text.find_first_of("0123456789", at), "", word());
        break;
      default:
        repeat_line(text, at);
    }
  }
  /// The rest of the line behind the next `mark`, or the word there.
  static void replace(std::string& text, std::size_t at, const std::string& mark,
                      const std::string& by) {
    const std::size_t found = at == std::string::npos ? at : text.find(mark, at);
    if (found == std::string::npos) return;
    const std::size_t begin = found + mark.size();
    const std::size_t end = text.find_first_of(mark.empty() ? " ,\n]}" : "\n", begin);
    text.replace(begin, std::min(end, text.size()) - begin, by);
  }
  void repeat_line(std::string& text, std::size_t at) {
    const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
    const std::string line = text.substr(begin, text.find('\n', begin) - begin) + "\n";
    const std::size_t times = below(2) == 0 ? 1 : 20'000;
    std::string lines;
    for (std::size_t i = 0; i < times; ++i) lines += line;
    text.insert(begin, lines);
  }

  std::mt19937 random_;
};

class FilesFuzz : public ::testing::TestWithParam<FileKind> {
 protected:
  FilesFuzz() {
    const fs::path source = fs::path(TOCSIN_REPOSITORY);
    for (const char* folder : {"bringup", "config"}) {
      fs::copy(source / folder, folder_.path(folder), fs::copy_options::recursive);
    }
    folder_.write("config/maps/classroom.pgm", "P2 2 2 255\n0 255 255 0\n");
    folder_.write("config/faults.yaml",
                  "faults:\n  - {kind: loss, at_s: 1, for_s: 2, amount: 0.5}\n"
                  "  - {kind: crash, at_s: 5, target: uxv/link}\n");
  }
  TemporaryFolder folder_;
};

TEST_P(FilesFuzz, IsReadAsItIs) { EXPECT_NO_THROW(GetParam().load(folder_.path(GetParam().name))); }

TEST_P(FilesFuzz, IsReadOrRefusedHoweverItIsBroken) {
  rlimit usual{};
  ::getrlimit(RLIMIT_AS, &usual);
  const rlimit limit{most_memory, usual.rlim_max};
  ::setrlimit(RLIMIT_AS, &limit);
  const std::string good = folder_.read(GetParam().name);
  for (unsigned seed = 1; seed <= mutations_of_a_kind; ++seed) {
    const std::string path = folder_.write(GetParam().name, Mutation(seed).of(good));
    try {
      GetParam().load(path);
    } catch (const ConfigError& error) {
      const std::string text = error.what();
      EXPECT_EQ(std::count_if(text.begin(), text.end(),
                              [](unsigned char c) { return c < ' ' || c == 0x7F; }),
                0)
          << seed << ": " << text;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
  }
  ::setrlimit(RLIMIT_AS, &usual);
}

std::string name_of(const ::testing::TestParamInfo<FileKind>& info) {
  std::string name = fs::path(info.param.name).parent_path().filename().string() + "_" +
                     fs::path(info.param.name).stem().string();
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, FilesFuzz, ::testing::ValuesIn(file_kinds()), name_of);

}  // namespace
}  // namespace tocsin::fuzz
