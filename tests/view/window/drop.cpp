#include "tests/view/window/drop.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <stdexcept>

namespace soms::view::test_window {

namespace {

constexpr long kVersion = 5;

/// The program that a file is dragged from.
class Source {
 public:
  Source(const std::string& name, ::Window target, std::string uri)
      : display_(XOpenDisplay(name.c_str())), target_(target), uri_(std::move(uri)) {
    if (display_ == nullptr) {
      throw std::runtime_error("no display " + name);
    }
    own_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), own_, CurrentTime);
  }

  ~Source() { XCloseDisplay(display_); }

  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  void drop() {
    send("XdndEnter", kVersion << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    send("XdndPosition", 0, place(), CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    wait_for("XdndStatus");
    send("XdndDrop", 0, CurrentTime, 0, 0);
    wait_for("XdndFinished");
  }

 private:
  [[nodiscard]] Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  /// The middle of the target on the screen: x above, y below.
  [[nodiscard]] long place() const {
    XWindowAttributes attributes;
    XGetWindowAttributes(display_, target_, &attributes);
    int x = 0;
    int y = 0;
    ::Window child = 0;
    XTranslateCoordinates(display_, target_, DefaultRootWindow(display_), attributes.width / 2,
                          attributes.height / 2, &x, &y, &child);
    return (static_cast<long>(x) << 16) | y;
  }

  void send(const char* message, long b, long c, long d, long e) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(own_);
    event.xclient.data.l[1] = b;
    event.xclient.data.l[2] = c;
    event.xclient.data.l[3] = d;
    event.xclient.data.l[4] = e;
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  /// Waits for a message of the target; hands out the name of the file when it is requested.
  void wait_for(const char* message) {
    const Atom wanted = atom(message);
    for (;;) {
      XEvent event;
      XNextEvent(display_, &event);
      if (event.type == ClientMessage && event.xclient.message_type == wanted) {
        return;
      }
      if (event.type == SelectionRequest) {
        hand_out(event.xselectionrequest);
      }
    }
  }

  void hand_out(const XSelectionRequestEvent& request) {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(uri_.data()),
                    static_cast<int>(uri_.size()));
    XEvent answer{};
    answer.xselection.type = SelectionNotify;
    answer.xselection.requestor = request.requestor;
    answer.xselection.selection = request.selection;
    answer.xselection.target = request.target;
    answer.xselection.property = request.property;
    answer.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &answer);
    XFlush(display_);
  }

  ::Display* display_;
  ::Window own_ = 0;
  ::Window target_;
  std::string uri_;
};

}  // namespace

void drop_file(const std::string& display, unsigned long window,
               const std::filesystem::path& file) {
  Source(display, window, "file://" + file.string() + "\r\n").drop();
}

void set_density(const std::string& name, int density) {
  ::Display* const display = XOpenDisplay(name.c_str());
  if (display == nullptr) {
    throw std::runtime_error("no display " + name);
  }
  const std::string text = "Xft.dpi:\t" + std::to_string(96 * density) + "\n";
  XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8,
                  PropModeReplace, reinterpret_cast<const unsigned char*>(text.data()),
                  static_cast<int>(text.size()));
  XCloseDisplay(display);
}

}  // namespace soms::view::test_window
