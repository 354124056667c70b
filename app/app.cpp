#include "app/app.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>

#include "app/app_state.hpp"
#include "app/commands.hpp"
#include "app/inspector.hpp"
#include "app/timeline.hpp"
#include "app/timeline_map.hpp"
#include "app/widgets.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

// The shortest and the longest time for playing the steps up to an outcome.
constexpr double kWatchedSeconds = 2, kLongestWatched = 4;
constexpr double kSecondsOfStep = 0.5;

/// Whether someone is at the controls in this frame: what was hovered or pressed has yet to be drawn.
bool has_input(const ImGuiIO& io) {
  return io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || io.MouseWheelH != 0 ||
         std::any_of(std::begin(io.MouseClicked), std::end(io.MouseClicked), std::identity{}) ||
         std::any_of(std::begin(io.MouseReleased), std::end(io.MouseReleased), std::identity{}) ||
         io.InputQueueCharacters.Size > 0;
}

bool same(const Settings& a, const Settings& b) {
  return a.theme == b.theme && a.text_scale == b.text_scale && a.least_words == b.least_words &&
         a.reduced_motion == b.reduced_motion && a.prose_in_canvas == b.prose_in_canvas && a.tools == b.tools &&
         a.show_optimum == b.show_optimum && a.labels == b.labels && a.ground == b.ground;
}

}  // namespace

void whiten(const ImFontAtlas& atlas) {
  for (ImTextureData* texture : atlas.TexList) {
    if (texture->Status != ImTextureStatus_WantCreate || texture->BytesPerPixel != 4) continue;
    unsigned char* const end = texture->Pixels + texture->Width * texture->Height * 4;
    for (unsigned char* pixel = texture->Pixels; pixel != end; pixel += 4)
      if (pixel[3] == 0) std::fill(pixel, pixel + 3, static_cast<unsigned char>(255));
  }
}

void AppState::load_fonts() {
  constexpr std::array<std::string_view, 4> kNames{"Inter-Regular", "Inter-SemiBold", "JetBrainsMono-Regular",
                                                   "JetBrainsMono-Bold"};
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  for (std::size_t i = 0; i < kNames.size(); ++i)
    font_bytes[i] = platform.font != nullptr ? platform.font(kNames[i]) : std::string();
  const auto add = [&](std::size_t i, bool merge) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.MergeMode = merge;
    if (font_bytes[i].empty()) return static_cast<ImFont*>(nullptr);
    return atlas->AddFontFromMemoryTTF(font_bytes[i].data(), static_cast<int>(font_bytes[i].size()), 15, &config);
  };
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    look.fonts[i] = add(i, false);
    add((i + 2) % 4, true);  // what Inter lacks (∈, ∪ …); accents, which figures and code go without
  }
  // A door that could not read one face shows its words in another.
  ImFont* any = *std::find_if(look.fonts.begin(), look.fonts.end() - 1, [](ImFont* font) { return font != nullptr; });
  for (ImFont*& font : look.fonts)
    if (font == nullptr) font = any;
}

void AppState::refresh_look(bool fingers) {
  look.palette = &palette_of(settings.theme);
  look.text_scale = settings.text_scale * look.palette->text, look.least = settings.least_words;
  look.fingers = fingers;
  look.still = settings.reduced_motion;
  apply_style(look);
}

void AppState::watch() {
  session->conversation().play_answers(!settings.reduced_motion);
  const lesson::Outcome* const outcome = session->conversation().deciding();
  if (outcome == nullptr) watched_pause = 0;
  if (outcome == nullptr || (watched_pause > 0 && now < watched_until)) return;
  if (watched_pause > 0) return end_watching();  // without one more step, which would continue
  const int steps = std::max(1, outcome->step - session->player().step());
  watched_pause = std::min(seconds_of_step(kWatchedSeconds / steps), kLongestWatched / steps);
  watched_until = now + kLongestWatched;
  playing = true;
  next_step_at = now + watched_pause;
}

void AppState::end_watching() {
  session->conversation().decide();
  playing = false;
  watched_pause = 0;
  settle = std::max(settle, 1);
}

double AppState::seconds_of_step(double watched) const {
  const lesson::HasFrames* const frames = session->stage().subject().frames();
  return frames != nullptr ? std::max(frames->seconds_of_frame(), watched) : kSecondsOfStep;
}

double AppState::pause() const {
  return watched_pause > 0 ? watched_pause : seconds_of_step(0) / static_cast<double>(speed);
}

void AppState::play_on() {
  watch();
  if (!playing) return;
  if (now - next_step_at > 1) next_step_at = now;  // nothing was drawn for a while: do not catch up
  while (playing && now >= next_step_at) {
    session->forward();
    next_step_at += pause();
    if (session->conversation().outcome() != nullptr || session->conversation().asked() != nullptr ||
        session->player().step() == session->player().steps())
      playing = false;
  }
  if (session->conversation().deciding() == nullptr) watched_pause = 0;
}

void AppState::decide_by_measuring() {
  const auto waits = [](const lesson::Outcome& outcome) { return outcome.pending && !outcome.skipped; };
  if (cover == nullptr || cover->running() || session->conversation().to_predict() != nullptr) return;
  if (std::any_of(session->log().outcomes().begin(), session->log().outcomes().end(), waits))
    cover->command(*session, "measure");
}

void AppState::draw_stage(const Rect& rect) {
  const std::string words = cover != nullptr ? cover->button().words : std::string();
  const float height = look.fingers ? 44.0f : look.px(32);
  look.tools_right =
      cover != nullptr && settings.tools ? app::measure(look, Face::kSemiBold, 13, words).x + look.px(28) : 0;
  const Rect above{rect.x, rect.y, rect.width, rect.height - look.foot};
  if (covered()) {
    // A question's card does not reach from side to side: the ground beside it is the cover's.
    ImGui::GetWindowDrawList()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height},
                                              look->ground);
    cover->draw(look, *session, above, settings.prose_in_canvas && look.foot <= 0);
  } else {
    stage.draw(look, settings, *session, rect, now);
  }
  if (cover == nullptr || !settings.tools) return;
  const float right = rect.x + rect.width - 12 - (covered() ? 0 : height + 8);
  if (button(ImGui::GetWindowDrawList(), look,
             {.id = "chart or shape",
              .rect = {right - look.tools_right, rect.y + 12, look.tools_right, height},
              .words = words,
              .kind = ButtonKind::kOutlined,
              .size = 13}))
    cover->show(!cover->shown());
}

std::optional<Rect> AppState::handle_to_drag(const Rect& rect) {
  constexpr float kReach = 12;
  std::vector<Handle> all = stage.handles(*session);
  std::erase_if(all, [&](const Handle& one) {
    return one.x < rect.x || one.y < rect.y || one.x > rect.x + rect.width || one.y > rect.y + rect.height;
  });
  if (all.empty()) return std::nullopt;
  auto chosen = std::find_if(all.begin(), all.end(), [&](const Handle& one) { return one.id == invited_handle; });
  if (chosen == all.end())
    chosen = std::max_element(all.begin(), all.end(), [](const Handle& a, const Handle& b) { return a.x < b.x; });
  invited_handle = chosen->id;
  return Rect{chosen->x - kReach, chosen->y - kReach, 2 * kReach, 2 * kReach};
}

void AppState::invite(const Rect& rect) {
  invitation.reset();
  const auto due = invitations.due(*session, playing);
  if (!due) return;
  const auto at = *due == lesson::Invited::kDrag   ? handle_to_drag(rect)
                  : *due == lesson::Invited::kStep ? std::optional(step_button)
                                                   : std::optional(play_button);
  if (at) invitation = Invitation{lesson::invitation_text(*due, invited_handle, step_words(*session)), *at};
}

void AppState::forget() {
  session->forget_answers();
  if (cover != nullptr) cover->show(false);
}

App::App(const Platform& platform) : state_(std::make_unique<AppState>()) {
  state_->platform = platform;
  state_->load_fonts();
  ImGui::GetIO().IniFilename = nullptr;
}
App::~App() = default;

bool App::create_graphics() {
  state_->settle = kSettleFrames;
  return state_->gl.create(state_->platform.glsl_version);
}
void App::abandon_graphics() { state_->gl.abandon(); }
const std::string& App::graphics_error() const { return state_->gl.error(); }

tl::expected<void, InputError> App::open(lesson::Lesson lesson, std::optional<io::PointFile> mesh, bool anew) {
  auto session = lesson::Session::open(std::move(lesson), std::move(mesh), state_->platform.clock);
  if (!session) return tl::unexpected(std::move(session.error()));
  state_->open(std::move(*session), anew);
  lesson::take_up(*state_->session, state_->answers[state_->session->lesson().id]);
  invite(lesson::Invitations::kAll);
  return {};
}

tl::expected<void, InputError> App::open_exercise(std::shared_ptr<const lesson::Exercise> exercise, std::uint64_t seed,
                                                  bool practises) {
  const auto instance = make_instance(*exercise, seed);
  if (!instance) return tl::unexpected(instance.error());
  auto session = open_instance(*exercise, *instance, state_->platform.clock, practises);
  if (!session) return tl::unexpected(std::move(session.error()));
  state_->open(std::move(*session), false);
  state_->sitting.emplace(std::move(exercise), seed, *state_->session, practises);
  invite(lesson::Invitations::kAll);
  return {};
}
lesson::Sitting* App::sitting() { return state_->sitting ? &*state_->sitting : nullptr; }
const lesson::Sitting* App::sitting() const { return state_->sitting ? &*state_->sitting : nullptr; }

void AppState::open(lesson::Session next, bool anew) {
  if (session && !sitting) answers[session->lesson().id] = lesson::answers_of(*session);
  sitting.reset();
  session.emplace(std::move(next));
  ++opened;
  session->stage().give_way(platform.gives_way);
  subject = &subject_of(session->lesson());
  view = subject->view();
  cover = subject->cover != nullptr ? subject->cover(platform) : nullptr;
  if (anew) stage.open_anew(*session, *view);
  else stage.open(*session, *view);
  stage.light("");
  to_top = !anew;
  playing = false;
  watched_pause = 0;
  settle = kSettleFrames;
}

void App::keep_answers(const std::string& lesson, lesson::KeptAnswers answers) {
  state_->answers[lesson] = std::move(answers);
}
void App::forget_answers() {
  state_->answers.clear();
  if (state_->session) state_->forget();
}

tl::expected<void, InputError> App::load(const io::PointFile& file, std::string_view name) {
  return state_->cover ? state_->cover->load(*state_->session, file, name) : state_->session->stage().load(file, name);
}
std::string_view App::subject() const {
  return state_->subject != nullptr ? state_->subject->name : std::string_view();
}
Cover* App::cover() { return state_->cover.get(); }
void App::measure(double budget) {
  if (state_->cover) state_->cover->work(*state_->session, budget);
}

App::SessionRevision App::session_revision() const {
  return {state_->opened, state_->session ? state_->session->revision() : 0};
}
lesson::Session* App::session() { return state_->session ? &*state_->session : nullptr; }
Settings& App::settings() { return state_->settings; }
const Look& App::look() const { return state_->look; }

bool App::end_playing() {
  const bool plays = state_->session && state_->session->conversation().deciding() != nullptr;
  if (plays) state_->end_watching();
  return plays;
}

bool App::command(std::string_view name) {
  AppState& s = *state_;
  if (!s.session) return false;
  if (end_playing()) return true;
  const auto draw_again = [&] { return s.settle = std::max(s.settle, 1), true; };
  if ((s.cover && s.cover->command(*s.session, name)) || s.view->command(*s.session, name)) return draw_again();
  const Command* const row = find_command(name);
  if (row == nullptr) return false;
  const int step = s.session->player().step();
  const bool done = row->does(s, name.substr(name.find(':') + 1));
  if (s.covered() && (s.playing || s.session->player().step() != step))
    s.cover->show(false);  // a step is shown on the stage
  return done && draw_again();
}

bool App::pick_choice(int choice) {
  if (!state_->session) return false;
  const bool done = state_->session->conversation().pick(lesson::OneChoice{choice});
  if (done) state_->decide_by_measuring();
  return done;
}

std::string_view App::command_of_key(std::string_view key, bool shift, bool control) const {
  const AppState& s = *state_;
  if (!s.session) return command_for(key, shift, control);
  if (!control && key == "Enter" && s.session->conversation().picked() != nullptr) return "commit_answer";
  if (const std::string_view own = s.cover ? s.cover->command_of_key(key) : ""; !own.empty() && !control) return own;
  // After a drag the arrows step; with Shift they move what it left selected.
  const Index point = s.stage.selected();
  const bool little = shift && key.starts_with("Arrow") && point != kNoIndex &&
                      s.session->conversation().asked() == nullptr && s.session->stage().may_move(point);
  return command_for(key, shift, control,
                     {.selected = s.stage.arrows_move() || little,
                      .exercise = s.sitting.has_value(),
                      .summary = s.session->conversation().at_summary()});
}

Index App::selected() const { return state_->stage.selected(); }
void App::select(Index point) {
  const bool valid = state_->session && point >= 0 && point < state_->session->stage().subject().size();
  state_->stage.select(valid ? point : kNoIndex);
  state_->settle = std::max(state_->settle, 1);
}
void App::light(std::string_view mark) {
  if (state_->stage.lit() == mark) return;
  state_->stage.light(mark);
  state_->settle = std::max(state_->settle, 1);
}
std::vector<double> App::hand_view() const {
  return state_->session && !state_->covered() ? state_->stage.camera().hand_view() : std::vector<double>();
}
bool App::look_from(const std::vector<double>& view) {
  return state_->session && state_->stage.look_from(*state_->session, view);
}
std::string_view App::lit() const { return state_->stage.lit(); }
std::vector<std::string_view> App::marks_in_hand() const {
  const Index hovered = state_->stage.hovered();
  if (!state_->session || hovered == kNoIndex || hovered >= state_->session->stage().subject().size()) return {};
  return lesson::marks_at(*state_->session, hovered);
}
void App::invite(int followed) {
  state_->invitations = lesson::Invitations(followed);
  state_->invitation.reset();
  state_->invited_handle.clear();
}
int App::invitations_followed() const { return state_->invitations.followed(); }
const std::optional<Invitation>& App::invitation() const { return state_->invitation; }
float App::free_height() const { return static_cast<float>(state_->stage.camera().room()[1]); }
float App::figures_height() const { return state_->figures_height; }
bool App::figures_fill() const { return state_->session && state_->view->fills_column(*state_->session); }
bool App::playing() const { return state_->playing; }
float App::speed() const { return state_->speed; }

void App::pinch(float factor, float x, float y, float dx, float dy) {
  state_->stage.pinch(factor, x, y, dx, dy);
  state_->settle = std::max(state_->settle, 1);
}

void App::frame(const Layout& layout, double now) {
  AppState& s = *state_;
  whiten(*ImGui::GetIO().Fonts);
  s.settle = has_input(ImGui::GetIO()) ? kSettleFrames : std::max(0, s.settle - 1);
  s.refresh_look(layout.fingers);
  s.look.tools = layout.tools;
  s.look.foot = layout.foot;
  ++s.frames;
  advance(now);
  if (!s.session) return;
  const lesson::WithDecimals wished(s.session->lesson().view.decimals);
  const ImGuiIO& io = ImGui::GetIO();
  const auto any = [](const bool(&of)[5]) { return std::any_of(std::begin(of), std::end(of), std::identity{}); };
  if (any(io.MouseClicked) && end_playing()) s.press_ends = true;
  const auto shows = [](const Rect& rect) { return rect.width >= 1 && rect.height >= 1; };
  // The timeline and the stage change the session; the inspector comes last, with the figures of the same frame.
  if (shows(layout.timeline)) {
    const Pane pane("##timeline", layout.timeline);
    const PlayerWish wish = draw_timeline(s.look, *s.session, *s.view, layout.timeline,
                                          {s.playing, s.speed, furthest_to_show(*s.session, sitting())});
    if (!wish.command.empty() && !s.press_ends) command(wish.command);
    if (wish.speed > 0) s.speed = wish.speed;
    s.step_button = wish.step, s.play_button = wish.play;
  }
  if (shows(layout.stage)) {
    const Pane pane("##stage", layout.stage);
    s.draw_stage(layout.stage);
  }
  s.figures_height = 0;
  if (shows(layout.inspector)) {
    if (std::exchange(s.to_top, false)) ImGui::SetNextWindowScroll({0, 0});
    const Pane pane("##inspector", layout.inspector, Pane::Kind::kScrolls);
    s.figures_height = draw_inspector(s.look, *s.session, *s.view, layout.inspector);
    const bool changed = s.session->revision() != s.drawn_revision;
    if (changed && ImGui::GetScrollMaxY() > 0) s.settle = std::max(s.settle, 1);  // it may scroll to the step's row
  }
  if (shows(layout.stage)) s.invite(layout.stage);
  if (!any(io.MouseDown)) s.press_ends = false;
  whiten(*ImGui::GetIO().Fonts);  // the atlas may have grown
  s.drawn_cover = s.cover ? s.cover->version() : 0;
  s.drawn_percent = s.percent();
  s.drawn_revision = s.session->revision();
  s.drawn_settings = s.settings;
}

void App::advance(double now) {
  // A door may draw panels of its own before the frame of this moment.
  if (std::exchange(state_->now, now) != now && state_->look.drawn != nullptr) state_->look.drawn->clear();
  if (!state_->session) return;
  state_->play_on();
  if (state_->sitting) state_->sitting->see(*state_->session);
}

void App::advance_unseen(double now) {
  advance(now);
  if (!state_->session) return;
  state_->view->work(*state_->session);
}

double App::seconds_until_unseen(double now) const {
  return state_->session && state_->view->working() ? 0 : seconds_until_step(now);
}

void App::draw_3d_behind(int framebuffer_width, int framebuffer_height, float scale) {
  if (state_->session && !state_->covered())
    state_->gl.draw(state_->stage.scene(), framebuffer_width, framebuffer_height, scale);
}

bool App::wants_frame(double now) const {
  const AppState& s = *state_;
  if (s.settle > 0 || !same(s.settings, s.drawn_settings)) return true;
  if (!s.session) return false;
  const bool moving = !s.covered() && s.stage.moving();  // the stage waits while it is covered
  const bool due = (s.playing && now >= s.next_step_at) || moving || s.session->revision() != s.drawn_revision;
  if (due || s.cover == nullptr) return due;
  const bool advanced =
      s.settings.prose_in_canvas && s.percent() != s.drawn_percent;  // the page has its progress bar outside the canvas
  return advanced || s.cover->version() != s.drawn_cover;
}

double App::seconds_until_due(double now) const { return wants_frame(now) ? 0 : seconds_until_step(now); }

double App::seconds_until_step(double now) const {
  if (state_->session && state_->session->conversation().deciding() != nullptr && !state_->playing) return 0;
  return state_->playing ? std::max(0.0, state_->next_step_at - now) : std::numeric_limits<double>::infinity();
}

void App::note_words(std::vector<DrawnWords>* drawn, bool apart) {
  state_->look.drawn = drawn, state_->look.words_apart = apart && drawn != nullptr;
}
long App::frames_drawn() const { return state_->frames; }
std::string App::caption() const {
  if (state_->covered()) return state_->cover->caption(*state_->session);
  return state_->session ? state_->session->telling().caption() : std::string();
}
std::vector<PanelWords> App::panel_words() const {
  if (!state_->session || state_->covered()) return {};
  const lesson::WithDecimals wished(state_->session->lesson().view.decimals);
  return state_->view->panel_words(*state_->session);
}
std::optional<CloseUp> App::close_up() const {
  return state_->session && !state_->covered() ? state_->stage.close_up() : std::nullopt;
}
std::optional<Handle> App::place_named(std::string_view name) const {
  return state_->session && !state_->covered() ? state_->stage.place_named(*state_->session, name) : std::nullopt;
}
const GlScene* App::scene() const { return state_->session && !state_->covered() ? &state_->stage.scene() : nullptr; }
std::vector<Handle> App::handles() const {
  if (state_->covered()) return state_->cover->handles();
  return state_->session ? state_->stage.handles(*state_->session) : std::vector<Handle>{};
}

}  // namespace snug::app
