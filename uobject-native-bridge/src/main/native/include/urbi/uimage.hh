/// Images. They do not own their data.
#ifndef URBI_UIMAGE_HH
#define URBI_UIMAGE_HH

#include <cstddef>
#include <ostream>
#include <string>

#include <urbi/fwd.hh>

namespace urbi
{
  enum UImageFormat
  {
    IMAGE_UNKNOWN = 0,
    IMAGE_RGB = 1,            ///< Red, green, blue: 3 bytes a pixel.
    IMAGE_YCbCr = 2,          ///< Luminance, blue and red difference: 3 bytes a pixel.
    IMAGE_YUV = 2,            ///< Another name of IMAGE_YCbCr.
    IMAGE_JPEG = 3,           ///< A JPEG file.
    IMAGE_PPM = 4,            ///< A PPM file, variant P6.
    IMAGE_YUV422 = 5,         ///< Y, U, Y, V for two pixels; also known as YUYV.
    IMAGE_GREY8 = 6,          ///< One byte a pixel.
    IMAGE_GREY4 = 7,          ///< Two pixels in a byte.
    IMAGE_YUV411_PLANAR = 8,  ///< All Y, then the U and the V of four neighbours in a row.
    IMAGE_NV12 = 9,           ///< All Y, then U and V in turn for two by two pixels.
    IMAGE_YUV420_PLANAR = 10, ///< All Y, all U, all V; one U and V for two by two pixels.
  };

  /// One more than the last format.
  enum
  {
    IMAGE_END = 11,
  };

  /// The word with which the header of such a binary begins.
  inline const char* format_string(UImageFormat format)
  {
    switch (format)
    {
    case IMAGE_RGB: return "rgb";
    case IMAGE_YCbCr: return "YCbCr";
    case IMAGE_JPEG: return "jpeg";
    case IMAGE_PPM: return "ppm";
    case IMAGE_YUV422: return "yuv422";
    case IMAGE_GREY8: return "grey8";
    case IMAGE_GREY4: return "grey4";
    case IMAGE_YUV411_PLANAR: return "yuv411planar";
    case IMAGE_NV12: return "nv12";
    case IMAGE_YUV420_PLANAR: return "yuv420planar";
    case IMAGE_UNKNOWN: break;
    }
    return "unknown format";
  }

  /// The format that a word stands for, in capitals or not.
  inline UImageFormat parse_image_format(const std::string& word)
  {
    std::string lower;
    for (char c : word)
      lower += 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (lower == "rgb")
      return IMAGE_RGB;
    if (lower == "ycbcr" || lower == "ycrcb" || lower == "yuv")
      return IMAGE_YCbCr;
    if (lower == "jpeg" || lower == "jpg")
      return IMAGE_JPEG;
    if (lower == "ppm")
      return IMAGE_PPM;
    if (lower == "yuv422" || lower == "yuyv")
      return IMAGE_YUV422;
    if (lower == "grey8")
      return IMAGE_GREY8;
    if (lower == "grey4")
      return IMAGE_GREY4;
    if (lower == "yuv411planar" || lower == "yuv411_planar")
      return IMAGE_YUV411_PLANAR;
    if (lower == "nv12")
      return IMAGE_NV12;
    if (lower == "yuv420planar" || lower == "yuv420_planar")
      return IMAGE_YUV420_PLANAR;
    return IMAGE_UNKNOWN;
  }

  /// The fields of an image. It has no constructor, so that it can be part of a union.
  class UImageImpl
  {
  public:
    unsigned char* data;
    size_t size;   ///< in bytes
    size_t width;  ///< in pixels
    size_t height; ///< in pixels
    UImageFormat imageFormat;

    static UImageImpl make()
    {
      UImageImpl image;
      image.init();
      return image;
    }

    /// Makes it empty.
    void init()
    {
      data = nullptr;
      size = width = height = 0;
      imageFormat = IMAGE_UNKNOWN;
    }

    const char* format_string() const
    {
      return urbi::format_string(imageFormat);
    }

    /// What it is, for people.
    std::ostream& dump(std::ostream& out) const
    {
      return out << format_string() << " " << width << "x" << height << " (" << size << " bytes)";
    }

    inline operator const UImage&() const;
    inline operator UImage&();
  };

  inline std::ostream& operator<<(std::ostream& out, const UImageImpl& image)
  {
    return image.dump(out);
  }

  /// An image. Copies share the data, nobody frees them.
  class UImage : public UImageImpl
  {
  public:
    UImage()
    {
      init();
    }

    explicit UImage(const UImageImpl& other)
      : UImageImpl(other)
    {}

    UImage& operator=(const UImageImpl& other)
    {
      static_cast<UImageImpl&>(*this) = other;
      return *this;
    }
  };

  // UImage adds nothing but constructors.
  inline UImageImpl::operator const UImage&() const
  {
    return static_cast<const UImage&>(*this);
  }

  inline UImageImpl::operator UImage&()
  {
    return static_cast<UImage&>(*this);
  }
}

#endif
