/// Bytes with a header that says what they are.
#ifndef URBI_UBINARY_HH
#define URBI_UBINARY_HH

#include <cstdlib>
#include <cstring>
#include <list>
#include <new>
#include <ostream>
#include <string>

#include <urbi/export.hh>
#include <urbi/uimage.hh>
#include <urbi/usound.hh>

namespace urbi
{
  /// Data of a binary as they came; of those who parse messages.
  class BinaryData
  {
  public:
    BinaryData()
      : data(nullptr)
      , size(0)
    {}

    BinaryData(void* d, size_t s)
      : data(d)
      , size(s)
    {}

    /// Frees the data.
    void clear()
    {
      std::free(data);
      data = nullptr;
      size = 0;
    }

    void* data;
    size_t size;
  };

  typedef std::list<BinaryData> binaries_type;

  enum UBinaryType
  {
    BINARY_NONE,
    BINARY_UNKNOWN,
    BINARY_IMAGE,
    BINARY_SOUND,
  };

  /// A binary. Copies are deep; its data are freed with it, by `free`, unless it was told to share
  /// those of another one.
  class UBinary
  {
  public:
    UBinary()
      : type(BINARY_NONE)
      , allocated_(true)
      , temporary_(false)
    {
      zero();
    }

    /// \param copy  whether the data are copied, or those of the other used as long as it lives
    /// \param temp  whether who copies this one may take its data away
    UBinary(const UBinary& other, bool copy = true, bool temp = false);

    UBinary(UBinary&& other) noexcept
      : UBinary()
    {
      swap(other);
    }

    explicit UBinary(const UImage& other, bool copy = true);

    explicit UBinary(const USound& other, bool copy = true);

    ~UBinary()
    {
      clear();
    }

    UBinary& operator=(const UBinary& other);

    UBinary& operator=(UBinary&& other) noexcept
    {
      if (this != &other)
      {
        clear();
        swap(other);
      }
      return *this;
    }

    /// Makes it empty.
    void clear();

    /// The header: the words that stand between the size and the data in urbiscript.
    std::string getMessage() const;

    /// Makes `message` what the fields say.
    void buildMessage()
    {
      message = getMessage();
    }

    /// Becomes what a header says, with those data.
    ///
    /// \param copy  whether the data are copied, or used in place and left alone
    void set(const std::string& header, void* bytes, size_t length, bool copy = true);

    /// Becomes what a header says, and uses those data. From one image to the next of the same size
    /// there is nothing else to be done.
    void share(const std::string& header, void* bytes, size_t length);

    /// Writes it as an urbiscript literal.
    std::ostream& print(std::ostream& out, int = 2) const;

    UBinaryType type;
    union
    {
      struct
      {
        void* data;
        size_t size; ///< in bytes
      } common;      ///< The beginning of the two others.
      UImageImpl image;
      USoundImpl sound;
    };
    std::string message; ///< The header as it came.
    bool allocated_;     ///< Whether the data are freed with it.
    bool temporary_;     ///< Whether its data may be taken away when it is copied.

  private:
    /// Appends a number to the words of a header.
    static void add(std::string& words, size_t number);

    /// The next number of a header; 0 without.
    static size_t number(const std::string& words, size_t& at);

    void zero()
    {
      sound.init();
      image.init();
    }

    void swap(UBinary& other) noexcept;

    void take(const UBinary& other, bool copy);

    /// The data are somebody else's: copies them, or remembers that.
    void own(bool copy);
  };

  inline std::ostream& operator<<(std::ostream& out, const UBinary& binary)
  {
    return binary.print(out);
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/ubinary.hh>
#endif

#endif
