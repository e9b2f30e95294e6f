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
    UBinary(const UBinary& other, bool copy = true, bool temp = false)
      : UBinary()
    {
      temporary_ = temp;
      take(other, copy);
    }

    UBinary(UBinary&& other) noexcept
      : UBinary()
    {
      swap(other);
    }

    explicit UBinary(const UImage& other, bool copy = true)
      : UBinary()
    {
      type = BINARY_IMAGE;
      image = other;
      own(copy);
    }

    explicit UBinary(const USound& other, bool copy = true)
      : UBinary()
    {
      type = BINARY_SOUND;
      sound = other;
      own(copy);
    }

    ~UBinary()
    {
      clear();
    }

    UBinary& operator=(const UBinary& other)
    {
      if (this != &other)
      {
        clear();
        take(other, true);
      }
      return *this;
    }

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
    void clear()
    {
      if (allocated_)
        std::free(common.data);
      zero();
      type = BINARY_NONE;
      allocated_ = true;
      message.clear();
    }

    /// The header: the words that stand between the size and the data in urbiscript.
    std::string getMessage() const
    {
      switch (type)
      {
      case BINARY_IMAGE:
      {
        std::string words(image.format_string());
        add(words, image.width);
        add(words, image.height);
        return words;
      }
      case BINARY_SOUND:
      {
        std::string words(sound.format_string());
        add(words, sound.channels);
        add(words, sound.rate);
        add(words, sound.sampleSize);
        add(words, static_cast<size_t>(sound.sampleFormat));
        return words;
      }
      case BINARY_NONE:
      case BINARY_UNKNOWN: break;
      }
      return message;
    }

    /// Makes `message` what the fields say.
    void buildMessage()
    {
      message = getMessage();
    }

    /// Becomes what a header says, with those data.
    ///
    /// \param copy  whether the data are copied, or used in place and left alone
    void set(const std::string& header, void* bytes, size_t length, bool copy = true)
    {
      clear();
      size_t at = header.find(' ');
      std::string first = header.substr(0, at);
      UImageFormat imageFormat = parse_image_format(first);
      USoundFormat soundFormat
        = imageFormat == IMAGE_UNKNOWN ? parse_sound_format(first) : SOUND_UNKNOWN;
      const std::string unknown = urbi::format_string(IMAGE_UNKNOWN);
      bool anyImage = header.compare(0, unknown.size() + 1, unknown + " ") == 0;
      if (anyImage)
        at = unknown.size();
      if (imageFormat != IMAGE_UNKNOWN || anyImage)
      {
        type = BINARY_IMAGE;
        image.width = number(header, at);
        image.height = number(header, at);
        image.imageFormat = imageFormat;
      }
      else if (soundFormat != SOUND_UNKNOWN)
      {
        type = BINARY_SOUND;
        sound.channels = number(header, at);
        sound.rate = number(header, at);
        sound.sampleSize = number(header, at);
        sound.sampleFormat = static_cast<USoundSampleFormat>(number(header, at));
        sound.soundFormat = soundFormat;
      }
      else
        type = header.empty() && length == 0 ? BINARY_NONE : BINARY_UNKNOWN;
      message = header;
      common.data = bytes;
      common.size = length;
      own(copy);
    }

    /// Becomes what a header says, and uses those data. From one image to the next of the same size
    /// there is nothing else to be done.
    void share(const std::string& header, void* bytes, size_t length)
    {
      if (allocated_ || message != header)
        set(header, bytes, length, false);
      else
      {
        common.data = bytes;
        common.size = length;
      }
    }

    /// Writes it as an urbiscript literal.
    std::ostream& print(std::ostream& out, int = 2) const
    {
      out << "BIN " << common.size;
      std::string header = getMessage();
      if (!header.empty())
        out << " " << header;
      out << ";";
      return out.write(static_cast<const char*>(common.data),
                       static_cast<std::streamsize>(common.size));
    }

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
    static void add(std::string& words, size_t number)
    {
      char digits[24];
      char* at = digits + sizeof digits;
      do
        *--at = static_cast<char>('0' + number % 10);
      while (number /= 10);
      *--at = ' ';
      words.append(at, digits + sizeof digits);
    }

    /// The next number of a header; 0 without.
    static size_t number(const std::string& words, size_t& at)
    {
      size_t read = 0;
      while (at < words.size() && words[at] == ' ')
        ++at;
      for (; at < words.size() && '0' <= words[at] && words[at] <= '9'; ++at)
        read = read * 10 + static_cast<size_t>(words[at] - '0');
      return read;
    }

    void zero()
    {
      sound.init();
      image.init();
    }

    void swap(UBinary& other) noexcept
    {
      std::swap(type, other.type);
      USoundImpl fields = sound;
      sound = other.sound;
      other.sound = fields;
      std::swap(message, other.message);
      std::swap(allocated_, other.allocated_);
    }

    void take(const UBinary& other, bool copy)
    {
      type = other.type;
      switch (type)
      {
      case BINARY_IMAGE: image = other.image; break;
      case BINARY_SOUND: sound = other.sound; break;
      case BINARY_NONE:
      case BINARY_UNKNOWN: common = other.common; break;
      }
      message = other.message;
      if (copy && other.temporary_ && other.allocated_)
      {
        allocated_ = true;
        UBinary& giver = const_cast<UBinary&>(other);
        giver.common.data = nullptr;
        giver.common.size = 0;
      }
      else
        own(copy);
    }

    /// The data are somebody else's: copies them, or remembers that.
    void own(bool copy)
    {
      allocated_ = copy;
      if (!copy)
        return;
      void* source = common.data;
      common.data = nullptr;
      if (source && common.size)
      {
        common.data = std::malloc(common.size);
        if (!common.data)
          throw std::bad_alloc();
        std::memcpy(common.data, source, common.size);
      }
    }
  };

  inline std::ostream& operator<<(std::ostream& out, const UBinary& binary)
  {
    return binary.print(out);
  }
}

#endif
