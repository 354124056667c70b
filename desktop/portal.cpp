#include "desktop/portal.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <type_traits>

namespace snug::desktop {
namespace {

// What is called of libdbus, by its documented interface: its headers are not needed to build.
constexpr int kSessionBus = 0, kSignal = 4, kError = 3, kMethodReturn = 2;
constexpr int kByte = 'y', kUint32 = 'u', kString = 's', kObjectPath = 'o', kArray = 'a', kVariant = 'v', kStruct = 'r',
              kDictEntry = 'e';
using Connection = void;
using Message = void;
/// Room for the library's own iterator, which is smaller in all of its versions.
struct alignas(void*) Iter {
  unsigned char bytes[256];
};

struct Library {
  Connection* (*bus_get_private)(int type, void* error);
  const char* (*bus_get_unique_name)(Connection*);
  void (*bus_add_match)(Connection*, const char* rule, void* error);
  void (*set_exit_on_disconnect)(Connection*, unsigned exits);
  unsigned (*send)(Connection*, Message*, std::uint32_t* serial);
  unsigned (*read_write)(Connection*, int milliseconds);
  Message* (*pop_message)(Connection*);
  Message* (*new_method_call)(const char* to, const char* path, const char* interface, const char* method);
  void (*unref)(Message*);
  int (*type)(Message*);
  const char* (*path)(Message*);
  const char* (*member)(Message*);
  std::uint32_t (*reply_serial)(Message*);
  void (*append)(Message*, Iter*);
  unsigned (*open_container)(Iter*, int type, const char* signature, Iter* inside);
  unsigned (*append_basic)(Iter*, int type, const void* value);
  unsigned (*close_container)(Iter*, Iter* inside);
  unsigned (*read)(Message*, Iter*);
  int (*arg_type)(Iter*);
  void (*recurse)(Iter*, Iter* inside);
  void (*get_basic)(Iter*, void* value);
  unsigned (*next)(Iter*);
  bool complete = false;
};

const Library& library() {
  static const Library loaded = [] {
    Library all{};
    void* const handle = dlopen("libdbus-1.so.3", RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return all;
    all.complete = true;
    const auto take = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
      all.complete = all.complete && function != nullptr;
    };
    take(all.bus_get_private, "dbus_bus_get_private"), take(all.bus_get_unique_name, "dbus_bus_get_unique_name");
    take(all.bus_add_match, "dbus_bus_add_match");
    take(all.set_exit_on_disconnect, "dbus_connection_set_exit_on_disconnect");
    take(all.send, "dbus_connection_send"), take(all.read_write, "dbus_connection_read_write");
    take(all.pop_message, "dbus_connection_pop_message");
    take(all.new_method_call, "dbus_message_new_method_call"), take(all.unref, "dbus_message_unref");
    take(all.type, "dbus_message_get_type"), take(all.path, "dbus_message_get_path");
    take(all.member, "dbus_message_get_member"), take(all.reply_serial, "dbus_message_get_reply_serial");
    take(all.append, "dbus_message_iter_init_append");
    take(all.open_container, "dbus_message_iter_open_container");
    take(all.append_basic, "dbus_message_iter_append_basic");
    take(all.close_container, "dbus_message_iter_close_container");
    take(all.read, "dbus_message_iter_init"), take(all.arg_type, "dbus_message_iter_get_arg_type");
    take(all.recurse, "dbus_message_iter_recurse"), take(all.get_basic, "dbus_message_iter_get_basic");
    take(all.next, "dbus_message_iter_next");
    return all;
  }();
  return loaded;
}

constexpr const char *kPortal = "org.freedesktop.portal.Desktop", *kPortalPath = "/org/freedesktop/portal/desktop";

// ---- what is sent

/// Appends to a message, or to a container in it.
class Writer {
 public:
  explicit Writer(Message* message) { library().append(message, &iter_); }
  void string(const std::string& text, int type = kString) {
    const char* const value = text.c_str();
    library().append_basic(&iter_, type, &value);
  }
  void number(std::uint32_t value) { library().append_basic(&iter_, kUint32, &value); }
  void byte(char value) { library().append_basic(&iter_, kByte, &value); }
  /// fill: what is in the container.
  template <class Fill>
  void container(int type, const char* signature, Fill&& fill) {
    Writer inside;
    library().open_container(&iter_, type, signature, &inside.iter_);
    fill(inside);
    library().close_container(&iter_, &inside.iter_);
  }
  template <class Fill>
  void option(const std::string& key, const char* signature, Fill&& fill) {
    container(kDictEntry, nullptr, [&](Writer& entry) {
      entry.string(key);
      entry.container(kVariant, signature, fill);
    });
  }

 private:
  Writer() = default;
  Iter iter_{};
};

/// Patterns of file names: upper case as well, for many a mesh is called PART.STL.
void write_filters(Writer& to, const std::vector<std::string>& endings) {
  const auto pattern = [](Writer& list, const std::string& text) {
    list.container(kStruct, nullptr, [&](Writer& one) { one.number(0), one.string(text); });
  };
  const auto filter = [&](Writer& all, const char* name, const auto& patterns) {
    all.container(kStruct, nullptr, [&](Writer& one) {
      one.string(name);
      one.container(kArray, "(us)", patterns);
    });
  };
  to.container(kArray, "(sa(us))", [&](Writer& all) {
    filter(all, "Files of this kind", [&](Writer& list) {
      for (const std::string& ending : endings) {
        std::string upper = ending;
        for (char& letter : upper) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
        pattern(list, "*." + ending), pattern(list, "*." + upper);
      }
    });
    filter(all, "All files", [&](Writer& list) { pattern(list, "*"); });
  });
}

// ---- what has been asked

/// The dialog that is open.
struct Request {
  std::string path;          // of its object on the bus
  std::uint32_t serial = 0;  // of the call that opened it
};

Connection* bus = nullptr;
Request request;
PortalAnswer answered;

/// Whether there is a session's bus: without one, the library would try to start one.
bool has_bus() {
  if (std::getenv("DBUS_SESSION_BUS_ADDRESS") != nullptr) return true;
  const char* const folder = std::getenv("XDG_RUNTIME_DIR");
  std::error_code error;
  return folder != nullptr && std::filesystem::exists(std::filesystem::path(folder) / "bus", error);
}

bool connect() {
  const Library& calls = library();
  if (bus != nullptr) return true;
  if (!calls.complete || !has_bus()) return false;
  bus = calls.bus_get_private(kSessionBus, nullptr);
  if (bus == nullptr) return false;
  calls.set_exit_on_disconnect(bus, 0);  // as it would by itself
  calls.bus_add_match(bus,
                      "type='signal',sender='org.freedesktop.portal.Desktop',"
                      "interface='org.freedesktop.portal.Request',member='Response'",
                      nullptr);
  return true;
}

std::uint32_t send(Message* message) {
  std::uint32_t serial = 0;
  library().send(bus, message, &serial);
  library().unref(message);
  library().read_write(bus, 0);
  return serial;
}

/// Where the portal will put a dialog's object, so that no answer can come before it is listened to.
std::string request_path(const std::string& token) {
  std::string sender = library().bus_get_unique_name(bus) + 1;  // after the colon
  for (char& letter : sender) letter = letter == '.' ? '_' : letter;
  return std::string(kPortalPath) + "/request/" + sender + '/' + token;
}

/// Closes a dialog that was left open.
void close_dialog() {
  if (request.path.empty()) return;
  send(library().new_method_call(kPortal, request.path.c_str(), "org.freedesktop.portal.Request", "Close"));
  request = {};
}

// ---- what is answered

/// file:///a%20b as a path; empty if it is not on this machine.
std::string path_of_uri(const std::string& uri) {
  constexpr std::string_view kFile = "file://";
  if (!uri.starts_with(kFile)) return {};
  std::string path;
  for (std::size_t i = uri.find('/', kFile.size()); i < uri.size(); ++i) {
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                         std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
    path += escaped ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (escaped) i += 2;
  }
  return path;
}

std::string string_at(Iter& iter) {
  const char* text = nullptr;
  if (library().arg_type(&iter) == kString) library().get_basic(&iter, &text);
  return text != nullptr ? text : "";
}

/// The first of the results' "uris", an a{sv}; empty if there is none.
std::string chosen_uri(Iter& results) {
  const Library& calls = library();
  if (calls.arg_type(&results) != kArray) return {};
  Iter entries;
  for (calls.recurse(&results, &entries); calls.arg_type(&entries) == kDictEntry; calls.next(&entries)) {
    Iter entry, value, uris;
    calls.recurse(&entries, &entry);
    if (string_at(entry) != "uris" || calls.next(&entry) == 0 || calls.arg_type(&entry) != kVariant) continue;
    calls.recurse(&entry, &value);
    if (calls.arg_type(&value) != kArray) continue;
    calls.recurse(&value, &uris);
    return string_at(uris);
  }
  return {};
}

/// A response to the dialog that is open.
PortalAnswer read_response(Message* message) {
  using Kind = PortalAnswer::Kind;
  constexpr std::uint32_t kChosen = 0, kCancelled = 1;
  const Library& calls = library();
  Iter iter;
  std::uint32_t response = kCancelled + 1;
  if (calls.read(message, &iter) != 0 && calls.arg_type(&iter) == kUint32) calls.get_basic(&iter, &response);
  if (response == kCancelled) return {Kind::kCancelled, {}};
  if (response != kChosen || calls.next(&iter) == 0) return {Kind::kNone, {}};
  std::string path = path_of_uri(chosen_uri(iter));
  return path.empty() ? PortalAnswer{Kind::kNone, {}} : PortalAnswer{Kind::kChosen, std::move(path)};
}

void take(Message* message) {
  const Library& calls = library();
  const int type = calls.type(message);
  const bool reply = (type == kMethodReturn || type == kError) && calls.reply_serial(message) == request.serial;
  if (reply && type == kError) answered.kind = PortalAnswer::Kind::kNone;  // nobody has such dialogs
  if (reply && type == kMethodReturn) {                                    // an old portal puts it elsewhere
    Iter iter;
    const char* path = nullptr;
    if (calls.read(message, &iter) != 0 && calls.arg_type(&iter) == kObjectPath) calls.get_basic(&iter, &path);
    if (path != nullptr) request.path = path;
  }
  const char *const path = calls.path(message), *const member = calls.member(message);
  if (type == kSignal && path != nullptr && request.path == path && member != nullptr &&
      std::string_view(member) == "Response")
    answered = read_response(message);
}

}  // namespace

bool open_portal(const char* title, const std::vector<std::string>& endings, bool saves, const std::string& proposed) {
  if (!connect()) return false;
  const Library& calls = library();
  close_dialog();
  static int dialogs = 0;
  const std::string token = "snug" + std::to_string(getpid()) + '_' + std::to_string(++dialogs);
  const std::filesystem::path path(proposed);
  Message* const call = calls.new_method_call(kPortal, kPortalPath, "org.freedesktop.portal.FileChooser",
                                              saves ? "SaveFile" : "OpenFile");
  Writer to(call);
  to.string("");  // no parent: GLFW does not say which window it is on Wayland
  to.string(title);
  to.container(kArray, "{sv}", [&](Writer& options) {
    options.option("handle_token", "s", [&](Writer& value) { value.string(token); });
    options.option("filters", "a(sa(us))", [&](Writer& value) { write_filters(value, endings); });
    if (!saves) return;
    options.option("current_name", "s", [&](Writer& value) { value.string(path.filename().string()); });
    options.option("current_folder", "ay", [&](Writer& value) {
      value.container(kArray, "y", [&](Writer& bytes) {
        for (const char letter : path.parent_path().string()) bytes.byte(letter);
        bytes.byte('\0');
      });
    });
  });
  answered = {};
  request = {request_path(token), 0};
  request.serial = send(call);
  return true;
}

PortalAnswer portal_answer() {
  using Kind = PortalAnswer::Kind;
  if (bus == nullptr) return {Kind::kNone, {}};
  const Library& calls = library();
  const bool connected = calls.read_write(bus, 0) != 0;
  while (answered.kind == Kind::kWaits) {
    Message* const message = calls.pop_message(bus);
    if (message == nullptr) break;
    take(message);
    calls.unref(message);
  }
  if (!connected && answered.kind == Kind::kWaits) answered.kind = Kind::kNone;
  if (answered.kind != Kind::kWaits) request = {};
  if (!connected) bus = nullptr;  // the session's bus is gone
  return answered;
}

}  // namespace snug::desktop
