/// How values are laid out in the buffers of an exchange: numbers in the machine's own byte order,
/// nothing aligned.
#ifndef URBI_DETAIL_WIRE_HH
#define URBI_DETAIL_WIRE_HH

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include <urbi/detail/boundary.h>
#include <urbi/uvalue.hh>

namespace urbi
{
  namespace detail
  {
    /// What a value begins with.
    enum Mark : uint8_t
    {
      MARK_VOID = 0,
      MARK_NUMBER = 1,     ///< double
      MARK_STRING = 2,     ///< length (uint32), bytes
      MARK_LIST = 3,       ///< count (uint32), values
      MARK_DICTIONARY = 4, ///< count (uint32), keys as length and bytes, values
      MARK_BINARY = 5,     ///< header as length and bytes, size (int64), bytes
      MARK_SLOTNAME = 6,   ///< length (uint32), bytes
      MARK_POINTER = 7,    ///< a binary: header as length and bytes, size (int64), address (int64)
    };

    /// Writes into a buffer that was given, and into one of its own where that is too small.
    class Writer
    {
    public:
      /// \param whole  whether data of binaries are written too, or only where they are
      Writer(uint8_t* buffer, int64_t capacity, bool whole)
        : whole_(whole)
        , given_(buffer)
        , begin_(buffer)
        , length_(0)
        , capacity_(capacity)
      {}

      ~Writer()
      {
        if (begin_ != given_)
          std::free(begin_);
      }

      Writer(const Writer&) = delete;
      Writer& operator=(const Writer&) = delete;

      uint8_t* data()
      {
        return begin_;
      }

      int64_t size() const
      {
        return length_;
      }

      /// The buffer is now somebody else's.
      uint8_t* release()
      {
        uint8_t* out = begin_;
        begin_ = given_;
        return out;
      }

      void restart()
      {
        length_ = 0;
      }

      template <typename T>
      void raw(T number)
      {
        static_assert(std::is_arithmetic<T>::value, "numbers only");
        std::memcpy(room(sizeof number), &number, sizeof number);
      }

      void bytes(const void* all, size_t length)
      {
        if (length)
          std::memcpy(room(length), all, length);
      }

      void text(const std::string& all);

      void number(ufloat value)
      {
        raw(static_cast<uint8_t>(MARK_NUMBER));
        raw(value);
      }

      void nothing()
      {
        raw(static_cast<uint8_t>(MARK_VOID));
      }

      void string(const std::string& all)
      {
        raw(static_cast<uint8_t>(MARK_STRING));
        text(all);
      }

      void value(const UValue& v);

      void binary(const UBinary& b);

    private:
      uint8_t* room(size_t bytes)
      {
        int64_t wanted = length_ + static_cast<int64_t>(bytes);
        if (wanted > capacity_)
          grow(wanted);
        uint8_t* at = begin_ + length_;
        length_ = wanted;
        return at;
      }

      void grow(int64_t wanted);

      bool whole_;
      uint8_t* given_;
      uint8_t* begin_;
      int64_t length_;
      int64_t capacity_;
    };

    /// Reads what a Writer, or the host, has written.
    class Reader
    {
    public:
      Reader(const uint8_t* begin, int64_t length)
        : at_(begin)
        , end_(begin + length)
      {}

      bool ended() const
      {
        return at_ == end_;
      }

      template <typename T>
      T raw()
      {
        T number;
        std::memcpy(&number, take(sizeof number), sizeof number);
        return number;
      }

      std::string text();

      /// Whether a number is next; it is read then.
      bool number(ufloat& out)
      {
        if (at_ == end_ || *at_ != MARK_NUMBER)
          return false;
        ++at_;
        out = raw<ufloat>();
        return true;
      }

      /// Binaries that the host shares are shared.
      void value(UValue& out);

    private:
      const uint8_t* take(size_t bytes)
      {
        if (static_cast<size_t>(end_ - at_) < bytes)
          throw std::runtime_error("truncated value");
        const uint8_t* at = at_;
        at_ += bytes;
        return at;
      }

      const uint8_t* at_;
      const uint8_t* end_;
    };
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/wire.hh>
#endif

#endif
