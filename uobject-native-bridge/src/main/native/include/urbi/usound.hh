/// Sounds. They do not own their data.
#ifndef URBI_USOUND_HH
#define URBI_USOUND_HH

#include <cstddef>
#include <cstring>
#include <istream>
#include <ostream>
#include <string>

#include <urbi/fwd.hh>

namespace urbi
{
  enum USoundFormat
  {
    SOUND_RAW = 0,
    SOUND_WAV = 1,
    SOUND_MP3 = 2,
    SOUND_OGG = 3,
    SOUND_UNKNOWN = 4,
  };

  enum USoundSampleFormat
  {
    SAMPLE_SIGNED = 1,
    SAMPLE_UNSIGNED = 2,
    SAMPLE_FLOAT = 3,
  };

  /// The word with which the header of such a binary begins.
  inline const char* format_string(USoundFormat format)
  {
    switch (format)
    {
    case SOUND_RAW: return "raw";
    case SOUND_WAV: return "wav";
    case SOUND_MP3: return "mp3";
    case SOUND_OGG: return "ogg";
    case SOUND_UNKNOWN: break;
    }
    return "unknown format";
  }

  inline USoundFormat parse_sound_format(const std::string& word)
  {
    for (int i = SOUND_RAW; i < SOUND_UNKNOWN; ++i)
      if (word == format_string(static_cast<USoundFormat>(i)))
        return static_cast<USoundFormat>(i);
    return SOUND_UNKNOWN;
  }

  inline std::istream& operator>>(std::istream& in, USoundSampleFormat& format)
  {
    int number = 0;
    in >> number;
    format = static_cast<USoundSampleFormat>(number);
    return in;
  }

  /// The fields of a sound. It has no constructor, so that it can be part of a union.
  class USoundImpl
  {
  public:
    char* data;
    size_t size;       ///< in bytes
    size_t channels;   ///< 1 for mono, 2 for stereo
    size_t rate;       ///< samples in a second
    size_t sampleSize; ///< bits
    USoundFormat soundFormat;
    USoundSampleFormat sampleFormat;

    static USoundImpl make()
    {
      USoundImpl sound;
      sound.init();
      return sound;
    }

    /// Makes it empty.
    void init()
    {
      data = nullptr;
      size = channels = rate = sampleSize = 0;
      soundFormat = SOUND_UNKNOWN;
      sampleFormat = SAMPLE_UNSIGNED;
    }

    const char* format_string() const
    {
      return urbi::format_string(soundFormat);
    }

    bool operator==(const USoundImpl& other) const
    {
      return size == other.size && channels == other.channels && rate == other.rate
        && sampleSize == other.sampleSize && soundFormat == other.soundFormat
        && sampleFormat == other.sampleFormat
        && (size == 0 || std::memcmp(data, other.data, size) == 0);
    }

    /// What it is, for people.
    std::ostream& dump(std::ostream& out) const
    {
      return out << format_string() << " " << channels << " channels, " << rate << " Hz, "
                 << sampleSize << " bits (" << size << " bytes)";
    }

    inline operator const USound&() const;
    inline operator USound&();
  };

  inline std::ostream& operator<<(std::ostream& out, const USoundImpl& sound)
  {
    return sound.dump(out);
  }

  /// A sound. Copies share the data, nobody frees them.
  class USound : public USoundImpl
  {
  public:
    USound()
    {
      init();
    }

    explicit USound(const USoundImpl& other)
      : USoundImpl(other)
    {}

    USound& operator=(const USoundImpl& other)
    {
      static_cast<USoundImpl&>(*this) = other;
      return *this;
    }
  };

  // USound adds nothing but constructors.
  inline USoundImpl::operator const USound&() const
  {
    return static_cast<const USound&>(*this);
  }

  inline USoundImpl::operator USound&()
  {
    return static_cast<USound&>(*this);
  }
}

#endif
