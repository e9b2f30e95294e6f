/// Takes what a server sends apart.
#ifndef URBI_DETAIL_MESSAGE_SPLITTER_HH
#define URBI_DETAIL_MESSAGE_SPLITTER_HH

#include <cctype>
#include <cstdlib>
#include <string>

namespace urbi
{
  namespace detail
  {
    /// Takes the bytes of a server apart into messages.
    class MessageSplitter
    {
    public:
      /// Takes bytes in; calls `take(timestamp, tag, text)` for each message that is complete.
      template <typename Taker>
      void feed(const char* bytes, size_t length, const Taker& take)
      {
        pending_.append(bytes, length);
        for (;;)
        {
          size_t end = message_end();
          if (end == std::string::npos)
            return;
          std::string line = pending_.substr(0, end);
          pending_.erase(0, end + 1);
          while (!line.empty() && line.back() == '\r')
            line.pop_back();
          if (!line.empty())
            split(line, take);
        }
      }

    private:
      /// The line end after a message, past the data of its binaries.
      size_t message_end() const
      {
        size_t at = pending_.find("] ");
        if (at != std::string::npos
            && (pending_.compare(at + 2, 3, "***") == 0 || pending_.compare(at + 2, 3, "!!!") == 0))
          // Text for people, whatever is in it.
          return pending_.find('\n', at);
        at = 0;
        bool quoted = false;
        for (; at < pending_.size(); ++at)
        {
          char c = pending_[at];
          if (c == '\n')
            return at;
          if (quoted && c == '\\')
            ++at;
          else if (c == '"')
            quoted = !quoted;
          else if (!quoted && c == 'B' && pending_.compare(at, 4, "BIN ") == 0
                   && (at == 0 || !std::isalnum(static_cast<unsigned char>(pending_[at - 1]))))
          {
            size_t size = 0, digit = at + 4;
            for (; digit < pending_.size() && std::isdigit(static_cast<unsigned char>(pending_[digit]));
                 ++digit)
              size = size * 10 + static_cast<size_t>(pending_[digit] - '0');
            size_t header = pending_.find_first_of(";\n", digit);
            if (header == std::string::npos)
              return header;
            if (pending_.size() - header - 1 < size)
              return std::string::npos;
            at = header + size;
          }
        }
        return std::string::npos;
      }

      template <typename Taker>
      static void split(const std::string& line, const Taker& take)
      {
        size_t close = line.find(']');
        if (line[0] != '[' || close == std::string::npos)
          return;
        size_t colon = line.find(':');
        std::string tag;
        if (colon < close)
          tag = line.substr(colon + 1, close - colon - 1);
        int time = std::atoi(line.c_str() + 1);
        size_t text = close + 1;
        if (text < line.size() && line[text] == ' ')
          ++text;
        take(time, tag, line.substr(text));
      }

      std::string pending_;
    };
  }
}

#endif
