// SPDX-License-Identifier: Apache-2.0
#include "pages.hpp"

#include <cstdarg>
#include <cstdio>

namespace tocsin::kobuki {
namespace {

__attribute__((format(printf, 2, 3))) void line(std::string& page, const char* format, ...) {
  char text[160];
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  page += text;
  page += '\n';
}

const char* text_of(BaseState state) {
  static constexpr const char* texts[] = {"no port", "silent", "online", "refused"};
  return texts[static_cast<std::size_t>(state)];
}

const char* text_of(FirmwareSupport support) {
  static constexpr const char* texts[] = {"recommended", "should be replaced by 1.1.4 or 1.2.0",
                                          "newer than this software knows", "refused"};
  return texts[static_cast<std::size_t>(support)];
}

std::string battery_text(const Battery& battery) {
  static constexpr const char* states[] = {"discharging", "charged", "charging"};
  static constexpr const char* sources[] = {"", " by adapter", " at dock"};
  static constexpr const char* levels[] = {"dangerous", "low", "healthy", "full"};
  char text[96];
  std::snprintf(text, sizeof text, "%.1f V, %.0f %%, %s, %s%s", battery.voltage_v,
                100 * battery.percentage, levels[static_cast<std::size_t>(battery.level)],
                states[static_cast<std::size_t>(battery.state)],
                sources[static_cast<std::size_t>(battery.source)]);
  return text;
}

std::string sides(unsigned mask) {
  std::string text;
  text += (mask & left_bit) != 0 ? "LEFT " : "  .  ";
  text += (mask & centre_bit) != 0 ? "CENTRE " : "  .    ";
  text += (mask & right_bit) != 0 ? "RIGHT" : "  .  ";
  return text;
}

void motion(std::string& page, const Reading& r) {
  line(page, "odometry    x %7.3f m   y %7.3f m   heading %7.1f deg", r.pose.x_m, r.pose.y_m,
       r.pose.heading_rad / degree);
  line(page, "velocity    %6.3f m/s   %7.2f deg/s   gyro %7.1f deg", r.linear_mps,
       r.angular_rad_s / degree, r.gyro_heading_rad / degree);
  const CoreSensors& core = *r.feedback.core;
  line(page, "wheels      left %5u ticks %4d %%   right %5u ticks %4d %%", core.left_encoder,
       core.left_pwm, core.right_encoder, core.right_pwm);
}

void contact(std::string& page, const Reading& r) {
  const CoreSensors& core = *r.feedback.core;
  line(page, "bumper      %s", sides(core.bumper).c_str());
  line(page, "cliff       %s", sides(core.cliff).c_str());
  line(page, "wheel drop  %s %s", (core.wheel_drop & left_wheel_drop_bit) != 0 ? "LEFT " : "  .  ",
       (core.wheel_drop & right_bit) != 0 ? "RIGHT" : "  .  ");
  line(page, "buttons     %s %s %s", (core.buttons & 1U) != 0 ? "B0" : " .",
       (core.buttons & 2U) != 0 ? "B1" : " .", (core.buttons & 4U) != 0 ? "B2" : " .");
}

void analog(std::string& page, const Feedback& f) {
  if (f.cliff_adc) {
    line(page, "cliff ADC   left %4u   centre %4u   right %4u", f.cliff_adc->left,
         f.cliff_adc->centre, f.cliff_adc->right);
  }
  if (f.current) {
    line(page, "current     left %.2f A   right %.2f A", f.current->left / 100.0,
         f.current->right / 100.0);
  }
  if (f.dock_infrared) {
    line(page, "dock        left 0x%02x   centre 0x%02x   right 0x%02x", f.dock_infrared->left,
         f.dock_infrared->centre, f.dock_infrared->right);
  }
  if (f.input) {
    line(page, "inputs      digital 0x%04x   analog %u %u %u %u", f.input->digital,
         f.input->analog[0], f.input->analog[1], f.input->analog[2], f.input->analog[3]);
  }
}

}  // namespace

std::string info_page(const KobukiDriver& driver, const Reading& reading) {
  const Inquiry& known = driver.inquiry();
  std::string page;
  line(page, "hardware  %s", known.hardware() ? to_text(*known.hardware()).c_str() : "unknown");
  if (const auto& firmware = known.firmware()) {
    line(page, "firmware  %s (%s)", to_text(*firmware).c_str(), text_of(judge_firmware(*firmware)));
  } else {
    line(page, "firmware  unknown");
  }
  if (const auto& id = known.unique_id()) {
    line(page, "id        %u-%u-%u", (*id)[0], (*id)[1], (*id)[2]);
  } else {
    line(page, "id        unknown");
  }
  line(page, "battery   %s", battery_text(reading.battery).c_str());
  if (const auto& gains = known.gains()) {
    line(page, "gains     P %g, I %g, D %g (%s)", gains->kp_milli / 1000.0,
         gains->ki_milli / 1000.0, gains->kd_milli / 1000.0,
         gains->type == 0 ? "of the firmware" : "of the user");
  } else {
    const bool none = known.firmware() && !has_gains(*known.firmware());
    line(page, "gains     unknown%s", none ? ": firmware before 1.2 has none to read" : "");
  }
  return page;
}

std::string watch_page(const KobukiDriver& driver, const Reading& reading) {
  std::string page;
  line(page, "Kobuki      %s   base time %5u ms", text_of(driver.state()),
       reading.feedback.core->timestamp_ms);
  line(page, "battery     %s", battery_text(reading.battery).c_str());
  motion(page, reading);
  contact(page, reading);
  analog(page, reading.feedback);
  const auto& frames = driver.frame_counts();
  line(page, "frames      %llu good   %llu rejected   %llu bytes discarded",
       static_cast<unsigned long long>(frames.frames),
       static_cast<unsigned long long>(frames.rejected),
       static_cast<unsigned long long>(frames.discarded));
  return page;
}

}  // namespace tocsin::kobuki
