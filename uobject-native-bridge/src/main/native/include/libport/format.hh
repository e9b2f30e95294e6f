/// Texts with places for values.
#ifndef LIBPORT_FORMAT_HH
#define LIBPORT_FORMAT_HH

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace libport
{
  namespace detail
  {
    /// One place: %[flags][width][.precision]letter, %N$... or %N%.
    struct Place
    {
      size_t argument;
      std::string flags;
      int width;
      int precision; ///< -1 without
      char letter;   ///< 0 if there is none
    };

    /// The value as a place wants it.
    template <typename T>
    void show(std::ostream& out, const Place& place, const T& value)
    {
      for (char flag : place.flags)
        switch (flag)
        {
        case '-': out.setf(std::ios::left, std::ios::adjustfield); break;
        case '+': out.setf(std::ios::showpos); break;
        case '#': out.setf(std::ios::showbase | std::ios::showpoint); break;
        case '0':
          out.fill('0');
          if (place.flags.find('-') == std::string::npos)
            out.setf(std::ios::internal, std::ios::adjustfield);
          break;
        default: break;
        }
      if (place.precision >= 0 && place.letter != 's')
        out.precision(place.precision);
      switch (place.letter)
      {
      case 'X': out.setf(std::ios::uppercase); out.setf(std::ios::hex, std::ios::basefield); break;
      case 'x':
      case 'p': out.setf(std::ios::hex, std::ios::basefield); break;
      case 'o': out.setf(std::ios::oct, std::ios::basefield); break;
      case 'f': out.setf(std::ios::fixed, std::ios::floatfield); break;
      case 'E': out.setf(std::ios::uppercase); out.setf(std::ios::scientific, std::ios::floatfield); break;
      case 'e': out.setf(std::ios::scientific, std::ios::floatfield); break;
      default: break;
      }
      std::ostringstream text;
      text.copyfmt(out);
      text << std::boolalpha;
      if (place.letter != 's' && place.letter != 'b')
        text << std::noboolalpha;
      if (place.letter == 's' && place.precision >= 0)
      {
        text.width(0);
        text << value;
        out.width(place.width);
        out << text.str().substr(0, static_cast<size_t>(place.precision));
        return;
      }
      text.width(place.width);
      text << value;
      out.width(0);
      out << text.str();
    }

    /// Fills the places of a format one after the other.
    class Formatter
    {
    public:
      explicit Formatter(const std::string& format)
      {
        read(format);
      }

      template <typename T>
      void give(const T& value)
      {
        for (size_t i = 0; i < places_.size(); ++i)
          if (places_[i].argument == given_)
          {
            std::ostringstream out;
            show(out, places_[i], value);
            shown_[i] = out.str();
          }
        ++given_;
      }

      std::string text() const
      {
        if (given_ != wanted_)
          throw std::runtime_error("format: " + std::to_string(wanted_) + " arguments are wanted, not "
                                   + std::to_string(given_));
        std::string out = texts_[0];
        for (size_t i = 0; i < places_.size(); ++i)
          (out += shown_[i]) += texts_[i + 1];
        return out;
      }

    private:
      static int number(const std::string& all, size_t& at)
      {
        int read = 0;
        for (; at < all.size() && '0' <= all[at] && all[at] <= '9' && read < 100000; ++at)
          read = read * 10 + (all[at] - '0');
        return read;
      }

      void read(const std::string& all)
      {
        texts_.push_back("");
        size_t next = 0;
        for (size_t at = 0; at < all.size(); ++at)
        {
          if (all[at] != '%')
            texts_.back() += all[at];
          else if (at + 1 < all.size() && all[at + 1] == '%')
          {
            texts_.back() += '%';
            ++at;
          }
          else
            place(all, at, next);
        }
      }

      void place(const std::string& all, size_t& at, size_t& next)
      {
        Place made = {0, "", 0, -1, 0};
        ++at;
        bool bars = at < all.size() && all[at] == '|';
        at += bars;
        bool numbered = false;
        size_t begin = at;
        int first = number(all, at);
        if (at > begin && at < all.size() && (all[at] == '%' || all[at] == '$'))
        {
          numbered = true;
          made.argument = static_cast<size_t>(first - 1);
        }
        else
          at = begin;
        if (!numbered || all[at] == '$')
        {
          at += numbered;
          while (at < all.size() && std::string("-+ #0=_'").find(all[at]) != std::string::npos)
            made.flags += all[at++];
          made.width = number(all, at);
          if (at < all.size() && all[at] == '.')
            made.precision = number(all, ++at);
          while (at < all.size() && std::string("hlLqjzt").find(all[at]) != std::string::npos)
            ++at;
          if (at < all.size() && all[at] != '|')
            made.letter = all[at++];
          at -= !bars;
        }
        if (at >= all.size())
          throw std::runtime_error("format: unfinished: " + all);
        if (!numbered)
          made.argument = next++;
        if (made.argument + 1 > wanted_)
          wanted_ = made.argument + 1;
        places_.push_back(made);
        shown_.push_back("");
        texts_.push_back("");
      }

      std::vector<Place> places_;
      std::vector<std::string> shown_;
      std::vector<std::string> texts_; ///< Between the places: one more than these.
      size_t wanted_ = 0;
      size_t given_ = 0;
    };
  }

  /// Puts values into a text: \c %s stands for a value of any type, and the other letters of printf
  /// say how numbers look. \throw std::runtime_error if there are too many values, or too few
  template <typename... T>
  std::string format(const std::string& text, const T&... values)
  {
    detail::Formatter formatter(text);
    int order[] = {0, (formatter.give(values), 0)...};
    static_cast<void>(order);
    return formatter.text();
  }
}

#endif
