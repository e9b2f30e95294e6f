package org.urbi.kernel.observe;

import org.urbi.kernel.object.UrbiBinary;

/**
 * What a Binary holds that people can see or hear.
 *
 * @param keywords its header, such as {@code jpeg 320 240}
 * @param bytes its content, a byte in each character
 */
public record Media(String keywords, String bytes) {
  /** More bytes than that are not shown. */
  public static final int LONGEST = 4 << 20;

  /** By the first of its keywords: {@code image}, {@code sound}, or nothing that browsers show. */
  static String kind(UrbiBinary binary) {
    String first = binary.keywords().strip().split("\\s+", 2)[0];
    return switch (first) {
      case "jpeg", "jpg", "png", "rgb", "grey8" -> "image";
      case "wav", "mp3", "ogg" -> "sound";
      default -> first.startsWith("image/") ? "image" : first.startsWith("audio/") ? "sound" : "";
    };
  }
}
