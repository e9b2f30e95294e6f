package com.sun.image.codec.jpeg;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import urbi.media.ImageFiles;
import urbi.media.MediaException;

/** Reads an image. */
public final class JPEGImageDecoder {
  private final InputStream in;

  JPEGImageDecoder(InputStream in) {
    this.in = in;
  }

  /**
   * The image.
   *
   * @throws IOException if there is none, or a broken one
   */
  public BufferedImage decodeAsBufferedImage() throws IOException {
    try {
      return ImageFiles.read(in);
    } catch (MediaException e) {
      throw new IOException(e.getMessage(), e);
    }
  }
}
