package org.urbi.kernel.observe;

import java.nio.charset.StandardCharsets;
import urbi.media.ImageFormat;

/**
 * A binary (manual, "Binary"), which is not copied.
 *
 * @param keywords what it is: {@code jpeg}, {@code rgb 320 240}
 * @param content its bytes, one in each character
 */
public record Bytes(String keywords, String content) {
  /** Whether its keywords say that it is an image. */
  public boolean isImage() {
    return ImageFormat.of(keywords.strip().split("\\s+", 2)[0]) != ImageFormat.UNKNOWN;
  }

  /** The bytes, as a copy. */
  public byte[] bytes() {
    return content.getBytes(StandardCharsets.ISO_8859_1);
  }
}
