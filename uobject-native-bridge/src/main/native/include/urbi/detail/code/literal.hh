/// What urbi/detail/literal.hh declares, and what reads literals: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/detail/literal.hh>

#ifndef URBI_DETAIL_CODE_LITERAL_HH
#define URBI_DETAIL_CODE_LITERAL_HH

namespace urbi
{
  namespace detail
  {
    URBI_INLINE UValue& entry(UDictionary& dictionary, const std::string& name)
    {
      return dictionary.insert(UDictionary::value_type(name, UValue())).first->second;
    }

    URBI_INLINE std::string number_text(ufloat number)
    {
      if (number != number)
        return "nan";
      const ufloat infinity = std::numeric_limits<ufloat>::infinity();
      if (number == infinity || number == -infinity)
        return number < 0 ? "-inf" : "inf";
      char text[40];
      std::to_chars_result end = std::to_chars(text, text + sizeof text, number);
      return std::string(text, end.ptr);
    }

    URBI_INLINE std::string quoted(const std::string& text)
    {
      std::string out = "\"";
      for (char c : text)
        switch (c)
        {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\r': out += "\\r"; break;
        case '\t': out += "\\t"; break;
        default:
          if (static_cast<unsigned char>(c) < ' ' || c == 127)
          {
            const char* digits = "0123456789abcdef";
            out += "\\x";
            out += digits[(c >> 4) & 15];
            out += digits[c & 15];
          }
          else
            out += c;
        }
      return out + "\"";
    }

    /// Reads a literal: number, duration, string, list, dictionary, binary, or name.
    class LiteralReader
    {
    public:
      /// \param bins  data of the binaries; null if they follow their headers in the text itself
      LiteralReader(const char* begin, const char* end, const binaries_type* bins = nullptr,
                    binaries_type::const_iterator* binpos = nullptr)
        : begin_(begin)
        , at_(begin)
        , end_(end)
        , bins_(bins)
        , binpos_(binpos)
        , depth_(0)
      {}

      void seek(int position)
      {
        at_ = begin_ + position;
      }

      int position() const
      {
        return static_cast<int>(at_ - begin_);
      }

      /// Whether nothing but white space is left.
      bool ended()
      {
        blank();
        return at_ == end_;
      }

      /// \return false at an error, where the position stays
      bool value(UValue& out)
      {
        const int deepest = 500;
        if (++depth_ > deepest)
          return false;
        bool read = any(out);
        --depth_;
        return read;
      }

    private:
      bool any(UValue& out)
      {
        blank();
        if (at_ == end_)
          return false;
        if (*at_ == '"' || *at_ == '\'')
          return string(out);
        if (*at_ == '[')
          return sequence(out);
        if (std::isdigit(static_cast<unsigned char>(*at_)) || *at_ == '-' || *at_ == '.'
            || *at_ == '+')
          return number(out);
        return word(out);
      }

      void blank()
      {
        while (at_ != end_ && std::isspace(static_cast<unsigned char>(*at_)))
          ++at_;
      }

      bool take(const char* text)
      {
        size_t length = std::strlen(text);
        if (static_cast<size_t>(end_ - at_) < length || std::memcmp(at_, text, length) != 0)
          return false;
        at_ += length;
        return true;
      }

      bool number(UValue& out)
      {
        const char* start = at_;
        if (*at_ == '+')
          ++start;
        bool negative = *start == '-';
        ufloat sum = 0;
        bool duration = false;
        const char* next = start;
        for (;;)
        {
          ufloat read = 0;
          if (end_ - next >= 2 && next[0] == '0' && (next[1] == 'x' || next[1] == 'X'))
          {
            at_ = next + 2;
            const char* first = at_;
            read = static_cast<ufloat>(digits(16, end_));
            if (at_ == first)
              return false;
            next = at_;
          }
          else
          {
            std::from_chars_result done = std::from_chars(next, end_, read);
            if (done.ec != std::errc())
              return false;
            next = done.ptr;
          }
          at_ = next;
          ufloat factor = unit();
          if (factor == 0)
          {
            sum += read;
            break;
          }
          duration = true;
          sum += (duration && negative && read > 0 ? -read : read) * factor;
          next = at_;
          if (at_ == end_ || !std::isdigit(static_cast<unsigned char>(*at_)))
            break;
        }
        out = UValue(sum);
        return true;
      }

      /// A whole number; the digits are read, if there are any.
      size_t digits(int base, const char* limit)
      {
        size_t number = 0;
        for (; at_ != limit; ++at_)
        {
          int digit = *at_ >= '0' && *at_ <= '9' ? *at_ - '0'
            : *at_ >= 'a' && *at_ <= 'f'         ? *at_ - 'a' + 10
            : *at_ >= 'A' && *at_ <= 'F'         ? *at_ - 'A' + 10
                                                 : base;
          if (digit >= base)
            break;
          number = number * static_cast<size_t>(base) + static_cast<size_t>(digit);
        }
        return number;
      }

      /// The seconds of a unit of time; 0 if there is none.
      ufloat unit()
      {
        if (take("ms"))
          return 0.001;
        if (take("s"))
          return 1;
        if (take("min") || take("m"))
          return 60;
        if (take("h"))
          return 3600;
        return take("d") ? 86400 : 0;
      }

      bool text(std::string& out)
      {
        char quote = *at_++;
        while (at_ != end_ && *at_ != quote)
        {
          if (*at_ != '\\')
          {
            out += *at_++;
            continue;
          }
          if (++at_ == end_)
            return false;
          char c = *at_++;
          switch (c)
          {
          case 'n': out += '\n'; break;
          case 'r': out += '\r'; break;
          case 't': out += '\t'; break;
          case 'a': out += '\a'; break;
          case 'b': out += '\b'; break;
          case 'f': out += '\f'; break;
          case 'v': out += '\v'; break;
          case 'x': code(out, 16, 2); break;
          default:
            if ('0' <= c && c <= '7')
            {
              --at_;
              code(out, 8, 3);
            }
            else
              out += c;
          }
        }
        if (at_ == end_)
          return false;
        ++at_;
        return true;
      }

      void code(std::string& out, int base, int most)
      {
        out += static_cast<char>(digits(base, end_ - at_ < most ? end_ : at_ + most));
      }

      bool string(UValue& out)
      {
        std::string all;
        // Literals side by side are one.
        do
          if (!text(all))
            return false;
        while (blank(), at_ != end_ && *at_ == '"');
        out = UValue(all);
        return true;
      }

      bool sequence(UValue& out)
      {
        ++at_;
        blank();
        if (take("=>"))
        {
          out = UValue(UDictionary());
          blank();
          return take("]");
        }
        UList list;
        UDictionary dictionary;
        bool named = false;
        blank();
        while (!take("]"))
        {
          UValue element;
          if (!value(element))
            return false;
          blank();
          if (take("=>"))
          {
            if (element.type != DATA_STRING || (!named && list.size()))
              return false;
            named = true;
            if (!value(entry(dictionary, *element.stringValue)))
              return false;
          }
          else if (named)
            return false;
          else
            list.push_back(element);
          blank();
          if (!take(",") && (at_ == end_ || *at_ != ']'))
            return false;
          blank();
        }
        out = named ? UValue(dictionary) : UValue(list);
        return true;
      }

      bool word(UValue& out)
      {
        if (take("BIN "))
          return binary(out);
        const char* start = at_;
        while (at_ != end_
               && (std::isalnum(static_cast<unsigned char>(*at_)) || *at_ == '_' || *at_ == '.'
                   || *at_ == '$'))
          ++at_;
        std::string name(start, at_);
        if (name.empty())
          return false;
        if (name == "void" || name == "nil")
          out.clear();
        else if (name == "true" || name == "false")
          out = UValue(name == "true");
        else if (name == "inf" || name == "nan")
          out = UValue(name == "inf" ? std::numeric_limits<ufloat>::infinity()
                                     : std::numeric_limits<ufloat>::quiet_NaN());
        else
        {
          out = UValue(name);
          out.type = DATA_SLOTNAME;
        }
        return true;
      }

      bool binary(UValue& out)
      {
        const char* first = at_;
        size_t size = digits(10, end_);
        if (at_ == first)
          return false;
        const char* stop = at_;
        while (stop != end_ && *stop != ';' && *stop != '\n')
          ++stop;
        while (at_ != stop && *at_ == ' ')
          ++at_;
        std::string header(at_, stop);
        UBinary made;
        if (bins_)
        {
          if (*binpos_ == bins_->end())
            return false;
          at_ = stop == end_ ? stop : stop + 1;
          made.set(header, (*binpos_)->data, (*binpos_)->size);
          ++*binpos_;
        }
        else
        {
          if (stop == end_ || static_cast<size_t>(end_ - stop - 1) < size)
            return false;
          made.set(header, const_cast<char*>(stop + 1), size);
          at_ = stop + 1 + size;
        }
        out = UValue(made);
        return true;
      }

      const char* begin_;
      const char* at_;
      const char* end_;
      const binaries_type* bins_;
      binaries_type::const_iterator* binpos_;
      int depth_;
    };

    URBI_INLINE bool read_literal(const std::string& text, UValue& out)
    {
      LiteralReader reader(text.data(), text.data() + text.size());
      return reader.value(out) && reader.ended();
    }
  }
}

#endif
