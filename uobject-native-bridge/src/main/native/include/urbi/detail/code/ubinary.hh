/// What urbi/ubinary.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/ubinary.hh>

#ifndef URBI_DETAIL_CODE_UBINARY_HH
#define URBI_DETAIL_CODE_UBINARY_HH

namespace urbi
{
  URBI_INLINE UBinary::UBinary(const UBinary& other, bool copy, bool temp)
    : UBinary()
  {
    temporary_ = temp;
    take(other, copy);
  }

  URBI_INLINE UBinary::UBinary(const UImage& other, bool copy)
    : UBinary()
  {
    type = BINARY_IMAGE;
    image = other;
    own(copy);
  }

  URBI_INLINE UBinary::UBinary(const USound& other, bool copy)
    : UBinary()
  {
    type = BINARY_SOUND;
    sound = other;
    own(copy);
  }

  URBI_INLINE UBinary& UBinary::operator=(const UBinary& other)
  {
    if (this != &other)
    {
      clear();
      take(other, true);
    }
    return *this;
  }

  URBI_INLINE void UBinary::clear()
  {
    if (allocated_)
      std::free(common.data);
    zero();
    type = BINARY_NONE;
    allocated_ = true;
    message.clear();
  }

  URBI_INLINE std::string UBinary::getMessage() const
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

  URBI_INLINE void UBinary::set(const std::string& header, void* bytes, size_t length, bool copy)
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

  URBI_INLINE void UBinary::share(const std::string& header, void* bytes, size_t length)
  {
    if (allocated_ || message != header)
      set(header, bytes, length, false);
    else
    {
      common.data = bytes;
      common.size = length;
    }
  }

  URBI_INLINE std::ostream& UBinary::print(std::ostream& out, int) const
  {
    out << "BIN " << common.size;
    std::string header = getMessage();
    if (!header.empty())
      out << " " << header;
    out << ";";
    return out.write(static_cast<const char*>(common.data),
                     static_cast<std::streamsize>(common.size));
  }

  URBI_INLINE void UBinary::add(std::string& words, size_t number)
  {
    char digits[24];
    char* at = digits + sizeof digits;
    do
      *--at = static_cast<char>('0' + number % 10);
    while (number /= 10);
    *--at = ' ';
    words.append(at, digits + sizeof digits);
  }

  URBI_INLINE size_t UBinary::number(const std::string& words, size_t& at)
  {
    size_t read = 0;
    while (at < words.size() && words[at] == ' ')
      ++at;
    for (; at < words.size() && '0' <= words[at] && words[at] <= '9'; ++at)
      read = read * 10 + static_cast<size_t>(words[at] - '0');
    return read;
  }

  URBI_INLINE void UBinary::swap(UBinary& other) noexcept
  {
    std::swap(type, other.type);
    USoundImpl fields = sound;
    sound = other.sound;
    other.sound = fields;
    std::swap(message, other.message);
    std::swap(allocated_, other.allocated_);
  }

  URBI_INLINE void UBinary::take(const UBinary& other, bool copy)
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

  URBI_INLINE void UBinary::own(bool copy)
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
}

#endif
