/// Binary streams of values: what was written is read in the same order.
#ifndef SERIALIZE_SERIALIZE_HH
#define SERIALIZE_SERIALIZE_HH

#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace libport
{
  namespace serialize
  {
    class Exception : public std::runtime_error
    {
    public:
      using std::runtime_error::runtime_error;
    };

    /// Writes values: numbers as they are in memory, texts and sequences with their length.
    class BinaryOSerializer
    {
    public:
      explicit BinaryOSerializer(std::ostream& out)
        : out_(out)
      {}

      std::ostream& stream()
      {
        return out_;
      }

      template <typename T>
      typename std::enable_if<std::is_arithmetic<T>::value || std::is_enum<T>::value,
                              BinaryOSerializer&>::type
      operator<<(const T& value)
      {
        out_.write(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
      }

      BinaryOSerializer& operator<<(const std::string& text)
      {
        *this << static_cast<uint32_t>(text.size());
        out_.write(text.data(), static_cast<std::streamsize>(text.size()));
        return *this;
      }

      template <typename T>
      BinaryOSerializer& operator<<(const std::vector<T>& all)
      {
        *this << static_cast<uint32_t>(all.size());
        for (const T& each : all)
          *this << each;
        return *this;
      }

    private:
      std::ostream& out_;
    };

    /// Reads what BinaryOSerializer has written.
    class BinaryISerializer
    {
    public:
      explicit BinaryISerializer(std::istream& in)
        : in_(in)
      {}

      std::istream& stream()
      {
        return in_;
      }

      /// \throw Exception at the end
      void bytes(char* to, size_t size)
      {
        if (!in_.read(to, static_cast<std::streamsize>(size)))
          throw Exception("truncated stream");
      }

      template <typename T>
      typename std::enable_if<std::is_arithmetic<T>::value || std::is_enum<T>::value,
                              BinaryISerializer&>::type
      operator>>(T& value)
      {
        bytes(reinterpret_cast<char*>(&value), sizeof value);
        return *this;
      }

      BinaryISerializer& operator>>(std::string& text)
      {
        uint32_t size = 0;
        *this >> size;
        text.clear();
        // A length that is not true is met by the end of the stream, and not by the end of memory.
        char buffer[4096];
        while (size)
        {
          size_t part = size < sizeof buffer ? size : sizeof buffer;
          bytes(buffer, part);
          text.append(buffer, part);
          size -= static_cast<uint32_t>(part);
        }
        return *this;
      }

      template <typename T>
      BinaryISerializer& operator>>(std::vector<T>& all)
      {
        uint32_t size = 0;
        *this >> size;
        all.clear();
        for (; size; --size)
        {
          T each;
          *this >> each;
          all.push_back(each);
        }
        return *this;
      }

    private:
      std::istream& in_;
    };
  }
}

#endif
