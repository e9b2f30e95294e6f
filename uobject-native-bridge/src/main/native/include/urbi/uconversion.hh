/// Conversion of images and sounds.
#ifndef URBI_UCONVERSION_HH
#define URBI_UCONVERSION_HH

#include <cmath>
#include <cstdlib>
#include <cstring>

#include <urbi/detail/host.hh>
#include <urbi/uvalue.hh>

namespace urbi
{
  typedef unsigned char byte;

  namespace detail
  {
    inline byte clipped(ufloat value)
    {
      return value <= 0 ? byte(0) : value >= 255 ? byte(255) : static_cast<byte>(value + 0.5);
    }

    /// Puts bytes where a destination wants them, which is made larger if they do not fit.
    template <typename T>
    void store(T*& data, size_t& size, const void* bytes, size_t length)
    {
      if (!data || size < length)
      {
        void* larger = std::realloc(static_cast<void*>(data), length ? length : 1);
        if (!larger)
          throw std::bad_alloc();
        data = static_cast<T*>(larger);
      }
      if (length)
        std::memcpy(static_cast<void*>(data), bytes, length);
      size = length;
    }

    /// Has the host convert a binary.
    inline UBinary converted(const UBinary& source, const UBinary& wanted, int quality)
    {
      Request request(URBI_CONVERT, 0);
      request.out.value(UValue(source, false));
      request.out.value(UValue(wanted, false));
      request.out.raw(static_cast<int64_t>(quality));
      request.send();
      UValue result;
      request.reply().value(result);
      return UBinary(std::move(*result.binary));
    }

    /// An image of bytes.
    inline UImage image_of(UImageFormat format, const byte* data, size_t size, size_t width,
                           size_t height)
    {
      UImage image;
      image.imageFormat = format;
      image.data = const_cast<byte*>(data);
      image.size = size;
      image.width = width;
      image.height = height;
      return image;
    }

    inline int decoded_jpeg(UImageFormat format, const byte* source, size_t length, byte** dest,
                            size_t& size, size_t& width, size_t& height)
    {
      UBinary wanted;
      wanted.type = BINARY_IMAGE;
      wanted.image.imageFormat = format;
      UBinary made
        = converted(UBinary(image_of(IMAGE_JPEG, source, length, 0, 0), false), wanted, 0);
      store(*dest, size, made.common.data, made.common.size);
      width = made.image.width;
      height = made.image.height;
      return 1;
    }

    inline int encoded_jpeg(UImageFormat format, const byte* source, size_t width, size_t height,
                            byte* dest, size_t& size, int quality)
    {
      UBinary wanted;
      wanted.type = BINARY_IMAGE;
      wanted.image.imageFormat = IMAGE_JPEG;
      UBinary made = converted(
        UBinary(image_of(format, source, 3 * width * height, width, height), false), wanted,
        quality);
      if (size < made.common.size)
        throw std::runtime_error("the JPEG image has " + number_text(static_cast<ufloat>(made.common.size))
                                 + " bytes, there is room for " + number_text(static_cast<ufloat>(size)));
      size = made.common.size;
      std::memcpy(dest, made.common.data, size);
      return 1;
    }
  }

  /// Swaps the two differences of each pixel.
  inline int convertYCrCbtoYCbCr(const byte* source, size_t length, byte* dest)
  {
    for (size_t i = 0; i + 2 < length; i += 3)
    {
      byte red = source[i + 1];
      dest[i] = source[i];
      dest[i + 1] = source[i + 2];
      dest[i + 2] = red;
    }
    return 1;
  }

  /// Red, green, blue to luminance, blue and red difference, as JPEG has them.
  inline int convertRGBtoYCbCr(const byte* source, size_t length, byte* dest)
  {
    for (size_t i = 0; i + 2 < length; i += 3)
    {
      ufloat r = source[i], g = source[i + 1], b = source[i + 2];
      dest[i] = detail::clipped(0.299 * r + 0.587 * g + 0.114 * b);
      dest[i + 1] = detail::clipped(128 - 0.168736 * r - 0.331264 * g + 0.5 * b);
      dest[i + 2] = detail::clipped(128 + 0.5 * r - 0.418688 * g - 0.081312 * b);
    }
    return 1;
  }

  /// Luminance, blue and red difference to red, green, blue.
  inline int convertYCbCrtoRGB(const byte* source, size_t length, byte* dest)
  {
    for (size_t i = 0; i + 2 < length; i += 3)
    {
      ufloat y = source[i], cb = source[i + 1] - 128.0, cr = source[i + 2] - 128.0;
      dest[i] = detail::clipped(y + 1.402 * cr);
      dest[i + 1] = detail::clipped(y - 0.344136 * cb - 0.714136 * cr);
      dest[i + 2] = detail::clipped(y + 1.772 * cb);
    }
    return 1;
  }

  /// Luminance by recommendation 601: one byte a pixel.
  inline int convertRGBtoGrey8_601(const byte* source, size_t length, byte* dest)
  {
    for (size_t i = 0; i + 2 < length; i += 3)
      dest[i / 3]
        = detail::clipped(0.299 * source[i] + 0.587 * source[i + 1] + 0.114 * source[i + 2]);
    return 1;
  }

  /// The image in a JPEG file; `*dest` is null or allocated by malloc, and made larger as needed.
  inline int convertJPEGtoRGB(const byte* source, size_t length, byte** dest, size_t& size,
                              size_t& width, size_t& height)
  {
    return detail::decoded_jpeg(IMAGE_RGB, source, length, dest, size, width, height);
  }

  inline int convertJPEGtoYCrCb(const byte* source, size_t length, byte** dest, size_t& size,
                                size_t& width, size_t& height)
  {
    detail::decoded_jpeg(IMAGE_YCbCr, source, length, dest, size, width, height);
    return convertYCrCbtoYCbCr(*dest, size, *dest);
  }

  /// A JPEG file of an image. \param size room in dest, and what is used of it
  inline int convertRGBtoJPEG(const byte* source, size_t width, size_t height, byte* dest,
                              size_t& size, int quality)
  {
    return detail::encoded_jpeg(IMAGE_RGB, source, width, height, dest, size, quality);
  }

  inline int convertYCrCbtoJPEG(const byte* source, size_t width, size_t height, byte* dest,
                                size_t& size, int quality)
  {
    std::string swapped(3 * width * height, '\0');
    byte* data = reinterpret_cast<byte*>(&swapped[0]);
    convertYCrCbtoYCbCr(source, swapped.size(), data);
    return detail::encoded_jpeg(IMAGE_YCbCr, data, width, height, dest, size, quality);
  }

  /// Makes an image of another one's, in the format and size that the destination has; what is 0
  /// there is as in the source. Its data are null, or allocated by malloc and made larger as needed.
  inline int convert(const UImage& source, UImage& destination)
  {
    UBinary wanted;
    wanted.type = BINARY_IMAGE;
    wanted.image.imageFormat
      = destination.imageFormat == IMAGE_UNKNOWN ? source.imageFormat : destination.imageFormat;
    wanted.image.width = destination.width;
    wanted.image.height = destination.height;
    UBinary made = detail::converted(UBinary(source, false), wanted, 0);
    destination.width = made.image.width;
    destination.height = made.image.height;
    destination.imageFormat = made.image.imageFormat;
    detail::store(destination.data, destination.size, made.common.data, made.common.size);
    return 1;
  }

  /// Makes a sound of another one's, with the channels, rate and samples that the destination has;
  /// what is 0 there is as in the source. Its data are as those of an image.
  inline int convert(const USound& source, USound& destination)
  {
    UBinary wanted;
    wanted.type = BINARY_SOUND;
    wanted.sound = destination;
    wanted.common.data = nullptr;
    wanted.common.size = 0;
    UBinary made = detail::converted(UBinary(source, false), wanted, 0);
    destination.channels = made.sound.channels;
    destination.rate = made.sound.rate;
    destination.sampleSize = made.sound.sampleSize;
    destination.sampleFormat = made.sound.sampleFormat;
    destination.soundFormat = made.sound.soundFormat;
    detail::store(destination.data, destination.size, made.common.data, made.common.size);
    return 1;
  }
}

#endif
