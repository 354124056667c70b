#include "app/subjects/cloud/certificate_panel.hpp"

#include <algorithm>
#include <string>

#include "app/marks.hpp"
#include "app/widgets.hpp"

namespace snug::app {
namespace {

constexpr float kCertificateRow = 20, kCertificateWords = 12, kCertificateDigits = 11;
constexpr float kCertificateMark = 18, kCertificateName = 30;  // the columns of ticks and of names

/// Writes the panel from top to bottom.
class CertificateWriter {
 public:
  CertificateWriter(const Look& look, const lesson::Session& session, ImVec2 at, float width)
      : look_(look), session_(session), list_(ImGui::GetWindowDrawList()), x_(at.x), y_(at.y), width_(width) {}

  void heading(std::string_view words) {
    text(list_, look_, Face::kSemiBold, 13, {x_, y_ + look_.px(5)}, look_->muted, words);
    y_ += look_.px(24);
  }
  void says(std::string_view words) {
    y_ += look_.px(4);
    y_ += paragraph(list_, look_, Face::kRegular, kCertificateWords, 17, {x_, y_}, width_, look_->muted, words) +
          look_.px(4);
  }

  void contained(const lesson::CertificateLines::Containment& line) {
    const bool outside = line.excess.sign > 0;
    const float top = y_;
    const Color ink = outside ? look_->wrong_text : look_->ink;
    mark(outside);
    name(line.point, ink);
    exact(line.excess, ink);
    point_at(line.point, top);
  }
  void support(const lesson::CertificateLines::Support& own) {
    const float top = y_;
    name(own.point, look_->support_text);
    const std::string off = own.ulps == 0 ? "0" : (own.ulps > 0 ? "+" : "") + lesson::number_text(own.ulps, 3);
    digits(off, x_ + width_ * 0.58f, look_->ink);
    if (own.weight) digits("λ = " + lesson::number_text(*own.weight), x_ + width_, look_->ink);
    y_ += look_.px(kCertificateRow);
    point_at(own.point, top);
  }
  void sum(std::string_view words, const lesson::ExactNumber& number) {
    text(list_, look_, Face::kRegular, kCertificateWords, {x_, middle(kCertificateWords)}, look_->ink, words);
    indent_ = measure(look_, Face::kRegular, kCertificateWords, words).x + 10;
    exact(number, look_->ink);
  }

  [[nodiscard]] float bottom() const { return y_; }
  [[nodiscard]] Index pointed() const { return pointed_; }

 private:
  [[nodiscard]] float middle(float size) const { return middle_of(y_ + look_.px(kCertificateRow) / 2, look_.px(size)); }

  void mark(bool wrong) {
    const ImVec2 at{x_ + 6, y_ + look_.px(kCertificateRow) / 2};
    if (wrong) cross(list_, at, 3.5f, look_->wrong, 2);
    else tick(list_, at, 4, look_->optimum, 2);
  }
  void name(Index point, Color ink) {
    text(list_, look_, Face::kMonoBold, kCertificateDigits, {x_ + kCertificateMark, middle(kCertificateDigits)}, ink,
         session_.stage().subject().name_of(point));
    indent_ = kCertificateMark + look_.px(kCertificateName);
  }
  void digits(std::string_view words, float right, Color ink) {
    text_right(list_, look_, Face::kMono, kCertificateDigits, {right, middle(kCertificateDigits)}, ink, words);
  }

  /// A number with all of its digits, on as many lines as they need.
  void exact(const lesson::ExactNumber& number, Color ink) {
    const float room = width_ - indent_;
    std::string left = number.whole;
    const auto fits = [&](const std::string& words) {
      return measure(look_, Face::kMono, kCertificateDigits, words).x <= room;
    };
    while (!fits(left + number.power)) {
      // Broken after a comma: the last one that leaves the line short enough.
      auto comma = left.rfind(',');
      while (comma != std::string::npos && comma > 0 && !fits(left.substr(0, comma + 1)))
        comma = left.rfind(',', comma - 1);
      if (comma == std::string::npos || comma == 0) break;
      digits(left.substr(0, comma + 1), x_ + width_, ink);
      left.erase(0, comma + 1);
      y_ += look_.px(kCertificateRow) * 0.75f;
    }
    digits(left + number.power, x_ + width_, ink);
    y_ += look_.px(kCertificateRow);
  }

  void point_at(Index point, float top) {
    const Rect row{x_ - 6, top, width_ + 12, y_ - top};
    if (!pointer_area(("row " + std::to_string(rows_++)).c_str(), row).hovered) return;
    pointed_ = point;
    list_->AddRectFilled({row.x, row.y}, {row.x + row.width, row.y + row.height}, with_alpha(look_->current, 0.14f), 4);
  }

  const Look& look_;
  const lesson::Session& session_;
  ImDrawList* list_;
  float x_, y_, width_;
  float indent_ = 0;  // where the digits of a row may begin
  int rows_ = 0;
  Index pointed_ = kNoIndex;
};

std::string other_points_text(const lesson::CertificateLines& lines) {
  const std::string count = lesson::count_text(lines.others) + " more, ";
  if (lines.others_outside == 0) return count + (lines.others == 1 ? "inside as well" : "all farther inside");
  return count + lesson::count_text(lines.others_outside) + " of them outside";
}

}  // namespace

float draw_certificate_panel(const Look& look, const lesson::Session& session, const CloudShown& shown, ImVec2 at,
                             float width, Index& pointed) {
  pointed = kNoIndex;
  if (!shown.certificate || session.telling().hides_result(*session.player().method(0))) return 0;
  const lesson::CertificateLines& lines = *shown.certificate;
  CertificateWriter writer(look, session, at, width);
  writer.heading("The certificate, number by number");
  writer.says("1. |p − c|² − r², exactly: above 0 is outside.");
  for (const auto& line : lines.contained) writer.contained(line);
  if (lines.others > 0) writer.says(other_points_text(lines));
  writer.says("2. How far the support set is off the boundary, in ulps of r: + is outside. 3. Its weights λ.");
  for (const auto& own : lines.support) writer.support(own);
  if (lines.sum_off) {
    writer.says("Left over by rounding the weights and c, exactly:");
    writer.sum("∑ λ − 1", *lines.sum_off);
    for (std::size_t axis = 0; axis < lines.mean_off.size(); ++axis)
      writer.sum(std::string("∑ λp − c, ") + "xyz"[axis], lines.mean_off[axis]);
  }
  if (lines.rounded) writer.says(lesson::rounded_text(*lines.rounded));
  pointed = writer.pointed();
  return writer.bottom() - at.y;
}

}  // namespace snug::app
