package org.urbi.bridge;

import urbi.UBinary;
import urbi.UBinaryType;
import urbi.UConversion;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.USound;
import urbi.UValue;

/** Converts images and sounds for {@code urbi/uconversion.hh}. */
final class Conversions {
  private Conversions() {}

  /**
   * Reads the source, the header of what is wanted, and a quality for JPEG, 0 for the usual one.
   */
  static UValue convert(ValueReader arguments) {
    UBinary source = arguments.value().ubinaryValue();
    UBinary wanted = arguments.value().ubinaryValue();
    int quality = (int) arguments.rawLong();
    if (wanted.getType() == UBinaryType.BINARY_SOUND) {
      USound sound = wanted.usoundValue();
      UConversion.convert(source.usoundValue(), sound);
      return new UValue(sound);
    }
    UImage from = source.uimageValue();
    UImage image = wanted.uimageValue();
    if (quality > 0 && image.getImageFormat() == UImageFormat.IMAGE_JPEG) {
      UImage rgb = new UImage();
      rgb.setImageFormat(UImageFormat.IMAGE_RGB);
      UConversion.convert(from, rgb);
      image.setWidth(rgb.getWidth());
      image.setHeight(rgb.getHeight());
      image.setData(
          UConversion.convertRGBtoJPEG(rgb.getData(), rgb.getWidth(), rgb.getHeight(), quality));
    } else {
      UConversion.convert(from, image);
    }
    return new UValue(image);
  }
}
