package com.sun.image.codec.jpeg;

import java.io.InputStream;

/** Makes decoders. */
public final class JPEGCodec {
  private JPEGCodec() {}

  /** A decoder of the image that a stream has. */
  public static JPEGImageDecoder createJPEGDecoder(InputStream in) {
    return new JPEGImageDecoder(in);
  }
}
