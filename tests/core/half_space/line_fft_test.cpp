/// Transforms of lines, lengths, the planner's lock and its wisdom.
#include "half_space/fft.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"

namespace wrc::test::line_fft_test {
namespace {

/// Roundings of a transform there and back, whose number grows like the logarithm of the length.
constexpr double roundings = 10.0;

bool has_small_factors(std::size_t length) {
  for (const std::size_t factor : {2U, 3U, 5U}) {
    while (length % factor == 0) {
      length /= factor;
    }
  }
  return length == 1;
}

TEST(LineLength, IsEvenAndNotMuchLonger) {
  for (std::size_t least = 0; least <= 5000; ++least) {
    const std::size_t length = fast_line_length(least);
    ASSERT_GE(length, std::max<std::size_t>(least, 2));
    ASSERT_EQ(length % (length < 32 ? 2 : 16), 0U) << least;
    ASSERT_TRUE(has_small_factors(length) || length == 14) << least;
    ASSERT_EQ(fast_line_length(length), length) << least;
    ASSERT_GE(fast_line_length(least + 1), length) << "grows with the length asked";
    // Next to 2^a stand 5/4 2^a and 3/2 2^a: at most a third longer.
    if (least >= 48) {
      ASSERT_LE(3 * length, 4 * (least + 16)) << least;
    }
  }
}

template <typename Real> class LineFftTest : public testing::Test {
protected:
  static std::vector<Real> random_line(std::size_t length) {
    std::mt19937_64 generator(length);
    std::vector<Real> line(length);
    for (Real& value : line) {
      value = static_cast<Real>(static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5);
    }
    return line;
  }
  static double tolerance(std::size_t length) {
    return roundings * static_cast<double>(std::numeric_limits<Real>::epsilon()) *
           static_cast<double>(length);
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(LineFftTest, Precisions, );

TYPED_TEST(LineFftTest, ThereAndBackIsTheLengthTimesTheLine) {
  using Complex = std::complex<TypeParam>;
  for (const std::size_t length : {1U, 2U, 6U, 16U, 30U, 37U, 80U, 144U, 400U, 1024U}) {
    const LineFft<TypeParam> fft(length, PlannerRigor::estimate);
    const std::vector<TypeParam> line = this->random_line(length);
    AlignedArray<Complex> first(length);
    AlignedArray<Complex> second(length);
    for (std::size_t i = 0; i < length; ++i) {
      first.data()[i] = {line[i], line[length - 1 - i]};
    }
    const std::vector<Complex> kept(first.data(), first.data() + length);
    fft.forward(first.data(), second.data());
    ASSERT_TRUE(std::equal(kept.begin(), kept.end(), first.data())) << "input is kept";
    fft.backward(second.data(), first.data());
    const auto scale = static_cast<TypeParam>(length);
    for (std::size_t i = 0; i < length; ++i) {
      ASSERT_NEAR(std::abs(first.data()[i] - scale * kept[i]), 0.0, this->tolerance(length));
    }
  }
}

TYPED_TEST(LineFftTest, IsTheFourierSum) {
  using Complex = std::complex<TypeParam>;
  const double pi = std::acos(-1.0);
  for (const std::size_t length : {1U, 2U, 10U, 16U, 21U, 48U}) {
    const LineFft<TypeParam> fft(length, PlannerRigor::estimate);
    const std::vector<TypeParam> line = this->random_line(length);
    AlignedArray<Complex> complex_line(length);
    AlignedArray<Complex> full(length);
    for (std::size_t i = 0; i < length; ++i) {
      complex_line.data()[i] = line[i];
    }
    fft.forward(complex_line.data(), full.data());
    for (std::size_t k = 0; k < length; ++k) {
      std::complex<double> expected;
      for (std::size_t i = 0; i < length; ++i) {
        expected += static_cast<double>(line[i]) *
                    std::polar(1.0, -2.0 * pi * static_cast<double>(k * i % length) /
                                        static_cast<double>(length));
      }
      const auto error = [&](const Complex& value) {
        return std::abs(std::complex<double>(value.real(), value.imag()) - expected);
      };
      ASSERT_LE(error(full.data()[k]), this->tolerance(length));
    }
  }
}

TYPED_TEST(LineFftTest, LinesThatComeTogetherAreTheSame) {
  using Complex = std::complex<TypeParam>;
  constexpr std::size_t most = 2 * block_lines;
  for (const std::size_t length : {2U, 14U, 16U, 20U, 21U, 32U, 48U, 80U}) {
    const LineFft<TypeParam> fft(length, PlannerRigor::estimate);
    EXPECT_EQ(fft.best_count(), length < 48 ? block_lines : 1U);
    const std::size_t pitch = aligned_pitch<Complex>(length);
    AlignedArray<Complex> lines(most * pitch);
    AlignedArray<Complex> together(most * pitch);
    AlignedArray<Complex> alone(most * pitch);
    const std::vector<TypeParam> values = this->random_line(most * pitch);
    std::copy(values.begin(), values.end(), lines.data());
    for (std::size_t count = 1; count <= most; ++count) {
      for (const bool forward : {true, false}) {
        const auto transform = [&](Complex* from, Complex* to, std::size_t of) {
          forward ? fft.forward(from, to, of) : fft.backward(from, to, of);
        };
        transform(lines.data(), together.data(), count);
        for (std::size_t line = 0; line < count; ++line) {
          transform(lines.data() + line * pitch, alone.data() + line * pitch, 1);
          for (std::size_t i = line * pitch; i < line * pitch + length; ++i) {
            ASSERT_NEAR(std::abs(together.data()[i] - alone.data()[i]), 0.0,
                        this->tolerance(length))
                << length << ", line " << line << " of " << count;
          }
        }
      }
    }
  }
}

TYPED_TEST(LineFftTest, RefusesLengthsOutOfRange) {
  EXPECT_THROW(LineFft<TypeParam>(0, PlannerRigor::estimate), Error);
  EXPECT_THROW(LineFft<TypeParam>(std::size_t{1} << 31, PlannerRigor::estimate), Error);
}

TEST(AlignedMemory, LinesStartAtAlignedPlaces) {
  for (std::size_t length = 0; length < 70; ++length) {
    const AlignedArray<float> array(length);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % vector_alignment, 0U);
    EXPECT_EQ(array.size(), length);
    EXPECT_GE(aligned_pitch<float>(length), length);
    EXPECT_LT(aligned_pitch<float>(length), length + 16);
    EXPECT_EQ(aligned_pitch<float>(length) % 16, 0U);
    EXPECT_EQ(aligned_pitch<std::complex<double>>(length) % 4, 0U);
  }
}

/// What the host's lock has seen.
struct LockRecord {
  int locked = 0;
  int unlocked = 0;
  bool nested = false;
};

void note_lock(void* context) {
  auto* record = static_cast<LockRecord*>(context);
  record->nested = record->nested || record->locked != record->unlocked;
  ++record->locked;
}

void note_unlock(void* context) {
  ++static_cast<LockRecord*>(context)->unlocked;
}

/// Sets the host's lock for one test.
class HostLock {
public:
  explicit HostLock(LockRecord& record) { set_planner_lock({note_lock, note_unlock, &record}); }
  ~HostLock() { set_planner_lock({}); }
  HostLock(const HostLock&) = delete;
  HostLock& operator=(const HostLock&) = delete;
};

TEST(PlannerLock, IsHeldDuringAllPlanning) {
  LockRecord record;
  {
    const HostLock lock(record);
    {
      const LineFft<float> single(48, PlannerRigor::estimate);
      EXPECT_GE(record.locked, 1);
      const int after_single = record.locked;
      const LineFft<double> wide(48, PlannerRigor::estimate);
      EXPECT_GT(record.locked, after_single);
      EXPECT_EQ(record.unlocked, record.locked);
    }
    // Destruction of plans changes FFTW's tables as well: two each.
    EXPECT_GE(record.locked, 2 + 4);
  }
  EXPECT_EQ(record.unlocked, record.locked);
  EXPECT_FALSE(record.nested) << "a lock that cannot be taken twice is enough";
  const int before = record.locked;
  const LineFft<float> without(32, PlannerRigor::estimate);
  EXPECT_EQ(record.locked, before) << "taken away again";
}

TEST(PlannerLock, OneOfTwoFunctionsIsAnError) {
  LockRecord record;
  for (const PlannerLock& half :
       {PlannerLock{note_lock, nullptr, &record}, PlannerLock{nullptr, note_unlock, &record}}) {
    expect_error(ErrorCode::invalid_argument, [&] { set_planner_lock(half); });
  }
  const LineFft<double> plan(32, PlannerRigor::estimate);
  EXPECT_EQ(record.locked + record.unlocked, 0) << "what was refused is not used";
}

TEST(PlannerLock, IsNotTakenForEstimatesAfterAMeasurement) {
  line_fft<float>(48, PlannerRigor::measure);
  LockRecord record;
  const HostLock lock(record);
  for (std::size_t length = 0; length < 2048;) {
    length = fast_line_length(length + 1);
    line_fft<float>(length, PlannerRigor::estimate);
    line_fft<double>(length, PlannerRigor::estimate);
  }
  EXPECT_EQ(record.locked, 0) << "made before it, so that it cannot change them";
}

/// A folder of its own, gone after the test.
class TemporaryFolder {
public:
  TemporaryFolder() {
    std::random_device seed;
    path_ = std::filesystem::temp_directory_path() /
            ("wrcontact-wisdom-" + std::to_string(seed()) + "-" + std::to_string(seed()));
    std::filesystem::create_directory(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
  std::filesystem::path path_;
};

ErrorCode code_of_loading(const std::string& path) {
  try {
    load_wisdom(path);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << "names the file";
    return error.code();
  }
  return ErrorCode::internal;
}

TEST(Wisdom, IsSavedAndLoaded) {
  const TemporaryFolder folder;
  const LineFft<float> single(16, PlannerRigor::measure);
  const LineFft<double> wide(16, PlannerRigor::measure);
  prepare_transforms();
  LockRecord record;
  {
    const HostLock lock(record);
    save_wisdom(folder.file("wisdom"));
    EXPECT_EQ(record.locked, 1);
    load_wisdom(folder.file("wisdom"));
    EXPECT_EQ(record.locked, 2);
    EXPECT_EQ(record.unlocked, 2);
  }
  // Loading what is known already changes nothing.
  save_wisdom(folder.file("again"));
  const auto text_of_file = [](const std::string& path) {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string text = text_of_file(folder.file("wisdom"));
  EXPECT_NE(text.find("fftw_wisdom"), std::string::npos);
  EXPECT_NE(text.find("fftwf_wisdom"), std::string::npos);
  EXPECT_EQ(text.size(), text_of_file(folder.file("again")).size());
}

TEST(Wisdom, BadFilesAreErrors) {
  const TemporaryFolder folder;
  EXPECT_EQ(code_of_loading(folder.file("absent")), ErrorCode::file_unreadable);
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.file(name), std::ios::binary) << text;
    return folder.file(name);
  };
  EXPECT_EQ(code_of_loading(write("empty", "")), ErrorCode::file_unreadable);
  EXPECT_EQ(code_of_loading(write("garbage", "no wisdom at all\n")), ErrorCode::file_malformed);
  EXPECT_EQ(code_of_loading(write("marked", "(x)\nsingle precision\n(y)\n")),
            ErrorCode::file_malformed);
  EXPECT_EQ(code_of_loading(write("binary", std::string(5000, '\0'))), ErrorCode::file_malformed);
  save_wisdom(folder.file("good"));
  std::ifstream good(folder.file("good"));
  const std::string text(std::istreambuf_iterator<char>(good), {});
  EXPECT_EQ(code_of_loading(write("half", text.substr(0, text.size() / 2))),
            ErrorCode::file_malformed);
  expect_error(ErrorCode::file_unreadable,
               [&] { save_wisdom(folder.file("no such folder/wisdom")); });
  // Plans can still be made after all this.
  EXPECT_NO_THROW(LineFft<double>(12, PlannerRigor::measure));
}

} // namespace
} // namespace wrc::test::line_fft_test
