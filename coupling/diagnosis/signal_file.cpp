#include "coupling/diagnosis/signal_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "mechanics/number_text.hpp"

namespace orbearing::diagnosis {

namespace {

void append_number(std::uint32_t number, int bytes, std::string& text) {
  for (int i = 0; i < bytes; ++i) text.push_back(static_cast<char>(number >> (8 * i) & 0xffu));
}

}  // namespace

std::string signal_csv(const Eigen::ArrayXd& signal, double rate, const Eigen::ArrayXd* shaft_angle) {
  using mechanics::significant;
  std::string text =
      shaft_angle != nullptr ? "time_s,acceleration_m_s2,shaft_angle_rad\n" : "time_s,acceleration_m_s2\n";
  for (Eigen::Index k = 0; k < signal.size(); ++k) {
    text += significant(static_cast<double>(k) / rate, 9) + "," + significant(signal[k], 9);
    if (shaft_angle != nullptr) text += "," + significant((*shaft_angle)[k], 12);
    text += "\n";
  }
  return text;
}

std::string signal_wav(const Eigen::ArrayXd& signal, double rate) {
  constexpr std::uint32_t bytes_each = 4, floating = 3, one_channel = 1, of_format = 16;
  const double largest = signal.abs().maxCoeff();
  const auto bytes = bytes_each * static_cast<std::uint32_t>(signal.size());
  const auto whole_rate = static_cast<std::uint32_t>(std::max(1L, std::lround(rate)));
  std::string text = "RIFF";
  append_number(36 + bytes, 4, text);
  text += "WAVEfmt ";
  append_number(of_format, 4, text);
  append_number(floating, 2, text);
  append_number(one_channel, 2, text);
  append_number(whole_rate, 4, text);
  append_number(bytes_each * whole_rate, 4, text);
  append_number(bytes_each, 2, text);
  append_number(8 * bytes_each, 2, text);
  text += "data";
  append_number(bytes, 4, text);
  for (const double sample : signal)
    append_number(std::bit_cast<std::uint32_t>(static_cast<float>(largest > 0.0 ? sample / largest : 0.0)), 4,
                  text);
  return text;
}

}  // namespace orbearing::diagnosis
