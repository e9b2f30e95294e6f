/// Messages for those who look for an error: GD_LEVEL in the environment says how many are shown.
#ifndef LIBPORT_DEBUG_HH
#define LIBPORT_DEBUG_HH

#include <cstdlib>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>

#include <libport/cassert>
#include <libport/compiler.hh>
#include <libport/containers.hh>
#include <libport/cstring>
#include <libport/foreach.hh>
#include <libport/format.hh>
#include <libport/lexical-cast.hh>

namespace libport
{
  namespace debug
  {
    /// How much is told.
    enum Level
    {
      LEVEL_NONE = 0,
      LEVEL_LOG = 1,
      LEVEL_TRACE = 2,
      LEVEL_DEBUG = 3,
      LEVEL_DUMP = 4,
    };

    inline Level level_of(const std::string& word)
    {
      const char* const names[] = {"NONE", "LOG", "TRACE", "DEBUG", "DUMP"};
      for (int i = 0; i < 5; ++i)
        if (word == names[i] || word == std::to_string(i))
          return static_cast<Level>(i);
      return LEVEL_LOG;
    }

    struct State
    {
      State()
      {
        const char* word = std::getenv("GD_LEVEL");
        level = word ? level_of(word) : LEVEL_LOG;
      }

      Level level;
      std::mutex lock;
    };

    LIBPORT_LOCAL inline State& state()
    {
      static State own;
      return own;
    }

    inline bool enabled(Level level)
    {
      return level <= state().level;
    }

    /// Shows a message, in one piece.
    inline void show(const char* category, const char* kind, const std::string& message)
    {
      std::string line = "[" + std::string(category) + "] " + kind + message + "\n";
      std::lock_guard<std::mutex> guard(state().lock);
      std::cerr << line << std::flush;
    }

    /// A message to which values are written.
    class Line
    {
    public:
      template <typename T>
      Line& operator<<(const T& value)
      {
        out_ << value;
        return *this;
      }

      std::string text() const
      {
        return out_.str();
      }

    private:
      std::ostringstream out_;
    };
  }
}

/// Has the messages that follow belong to a category: a name, or names with points.
#define GD_CATEGORY(...) static const char* const libport_gd_category ATTRIBUTE_UNUSED = #__VA_ARGS__

/// Once in a program; everything is ready without.
#define GD_INIT() static_assert(true, "")

#define GD_ENABLED(Level) (::libport::debug::enabled(::libport::debug::LEVEL_##Level))
#define GD_CURRENT_LEVEL() (::libport::debug::state().level)

// A message is a text, of GD_F... a format and its values, of GD_S... what may be written to a stream.
#define GD_SHOW_(Level, Kind, Message)                                                            \
  (GD_ENABLED(Level) ? ::libport::debug::show(libport_gd_category, Kind, string_cast(Message))    \
                     : static_cast<void>(0))
#define GD_FSHOW_(Level, Kind, ...)                                                               \
  (GD_ENABLED(Level)                                                                              \
     ? ::libport::debug::show(libport_gd_category, Kind, ::libport::format(__VA_ARGS__))          \
     : static_cast<void>(0))
#define GD_SSHOW_(Level, Kind, Stream)                                                            \
  (GD_ENABLED(Level) ? ::libport::debug::show(                                                    \
     libport_gd_category, Kind,                                                                   \
     (::libport::debug::Line() << Stream).text())                                                 \
                     : static_cast<void>(0))

#define GD_INFO(Message) GD_SHOW_(LOG, "", Message)
#define GD_FINFO(...) GD_FSHOW_(LOG, "", __VA_ARGS__)
#define GD_SINFO(Stream) GD_SSHOW_(LOG, "", Stream)
#define GD_INFO_LOG(Message) GD_SHOW_(LOG, "", Message)
#define GD_FINFO_LOG(...) GD_FSHOW_(LOG, "", __VA_ARGS__)
#define GD_SINFO_LOG(Stream) GD_SSHOW_(LOG, "", Stream)
#define GD_INFO_TRACE(Message) GD_SHOW_(TRACE, "", Message)
#define GD_FINFO_TRACE(...) GD_FSHOW_(TRACE, "", __VA_ARGS__)
#define GD_SINFO_TRACE(Stream) GD_SSHOW_(TRACE, "", Stream)
#define GD_INFO_DEBUG(Message) GD_SHOW_(DEBUG, "", Message)
#define GD_FINFO_DEBUG(...) GD_FSHOW_(DEBUG, "", __VA_ARGS__)
#define GD_SINFO_DEBUG(Stream) GD_SSHOW_(DEBUG, "", Stream)
#define GD_INFO_DUMP(Message) GD_SHOW_(DUMP, "", Message)
#define GD_FINFO_DUMP(...) GD_FSHOW_(DUMP, "", __VA_ARGS__)
#define GD_SINFO_DUMP(Stream) GD_SSHOW_(DUMP, "", Stream)
#define GD_PUSH(Message) GD_SHOW_(LOG, "", Message)
#define GD_FPUSH(...) GD_FSHOW_(LOG, "", __VA_ARGS__)
#define GD_SPUSH(Stream) GD_SSHOW_(LOG, "", Stream)
#define GD_PUSH_LOG(Message) GD_SHOW_(LOG, "", Message)
#define GD_FPUSH_LOG(...) GD_FSHOW_(LOG, "", __VA_ARGS__)
#define GD_SPUSH_LOG(Stream) GD_SSHOW_(LOG, "", Stream)
#define GD_PUSH_TRACE(Message) GD_SHOW_(TRACE, "", Message)
#define GD_FPUSH_TRACE(...) GD_FSHOW_(TRACE, "", __VA_ARGS__)
#define GD_SPUSH_TRACE(Stream) GD_SSHOW_(TRACE, "", Stream)
#define GD_PUSH_DEBUG(Message) GD_SHOW_(DEBUG, "", Message)
#define GD_FPUSH_DEBUG(...) GD_FSHOW_(DEBUG, "", __VA_ARGS__)
#define GD_SPUSH_DEBUG(Stream) GD_SSHOW_(DEBUG, "", Stream)
#define GD_PUSH_DUMP(Message) GD_SHOW_(DUMP, "", Message)
#define GD_FPUSH_DUMP(...) GD_FSHOW_(DUMP, "", __VA_ARGS__)
#define GD_SPUSH_DUMP(Stream) GD_SSHOW_(DUMP, "", Stream)
#define GD_WARN(Message) GD_SHOW_(LOG, "warning: ", Message)
#define GD_FWARN(...) GD_FSHOW_(LOG, "warning: ", __VA_ARGS__)
#define GD_SWARN(Stream) GD_SSHOW_(LOG, "warning: ", Stream)
#define GD_ERROR(Message) GD_SHOW_(LOG, "error: ", Message)
#define GD_FERROR(...) GD_FSHOW_(LOG, "error: ", __VA_ARGS__)
#define GD_SERROR(Stream) GD_SSHOW_(LOG, "error: ", Stream)
#define GD_FATAL(Message)                                                                         \
  (::libport::debug::show(libport_gd_category, "fatal: ", string_cast(Message)), std::abort())
#define GD_FFATAL(...)                                                                            \
  (::libport::debug::show(libport_gd_category, "fatal: ", ::libport::format(__VA_ARGS__)),        \
   std::abort())
#define GD_UNREACHABLE() GD_FATAL("unreachable code was reached")

#endif
