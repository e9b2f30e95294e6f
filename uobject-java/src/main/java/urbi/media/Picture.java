package urbi.media;

/**
 * An image in any format.
 *
 * @param width pixels in a row; 0 where the data say it themselves
 * @param height number of rows; 0 where the data say it themselves
 * @param data not copied
 */
public record Picture(ImageFormat format, int width, int height, byte[] data) {
  private static final int DEFAULT_QUALITY = 90;

  /**
   * The same image in another format and size.
   *
   * @param newWidth 0 for that of this one
   * @param newHeight 0 for that of this one
   * @return has data of its own
   * @throws MediaException if the data are too short or no such image, or the format is unknown
   */
  public Picture converted(ImageFormat newFormat, int newWidth, int newHeight) {
    Pixels pixels = ImageDecoder.decode(this);
    int wide = newWidth == 0 ? pixels.width() : newWidth;
    int high = newHeight == 0 ? pixels.height() : newHeight;
    boolean same = newFormat == format && wide == pixels.width() && high == pixels.height();
    byte[] bytes =
        same
            ? data.clone()
            : ImageEncoder.encode(pixels.scaled(wide, high), newFormat, DEFAULT_QUALITY);
    return new Picture(newFormat, wide, high, bytes);
  }

  /**
   * A JPEG file of the image.
   *
   * @param quality from 0 to 100
   * @throws MediaException as {@link #converted}
   */
  public byte[] toJpeg(int quality) {
    return ImageEncoder.encode(ImageDecoder.decode(this), ImageFormat.JPEG, quality);
  }
}
