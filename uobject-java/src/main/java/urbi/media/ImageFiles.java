package urbi.media;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import javax.imageio.ImageIO;

/** Files of images as windows show them: JPEG, PNG, GIF, BMP. Needs {@code java.desktop}. */
public final class ImageFiles {
  private ImageFiles() {}

  /**
   * Reads an image.
   *
   * @throws MediaException if it is none, or a broken one
   */
  public static BufferedImage read(byte[] file) {
    try {
      return read(new ByteArrayInputStream(file));
    } catch (IOException e) {
      throw new MediaException("a broken image: " + e.getMessage(), e);
    }
  }

  /**
   * Reads an image.
   *
   * @throws IOException if it cannot be read, or is broken
   * @throws MediaException if it is none
   */
  public static BufferedImage read(InputStream file) throws IOException {
    BufferedImage image = ImageIO.read(file);
    if (image == null) {
      throw new MediaException("no file of an image that is known here");
    }
    return image;
  }
}
