package org.urbi.ros.bridge;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/**
 * A text as the pixels of a PNG, which browsers inflate by themselves: what rosbridge calls the
 * compression {@code png}.
 */
final class PngText {
  private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  private static final int BYTES_OF_PIXEL = 3;

  private PngText() {}

  /** The image in Base64: red, green and blue are three bytes of the text; what is over is '\n'. */
  static String encode(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    int pixels = (bytes.length + BYTES_OF_PIXEL - 1) / BYTES_OF_PIXEL;
    int width = Math.max(1, (int) Math.floor(Math.sqrt(pixels)));
    int height = Math.max(1, (pixels + width - 1) / width);
    int row = width * BYTES_OF_PIXEL;
    byte[] rows = new byte[(row + 1) * height];
    Arrays.fill(rows, (byte) '\n');
    for (int y = 0; y < height; y++) {
      rows[y * (row + 1)] = 0;
      int length = Math.min(row, bytes.length - y * row);
      if (length > 0) {
        System.arraycopy(bytes, y * row, rows, y * (row + 1) + 1, length);
      }
    }
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    png.writeBytes(SIGNATURE);
    byte[] head =
        ByteBuffer.allocate(13)
            .putInt(width)
            .putInt(height)
            .put(new byte[] {8, 2, 0, 0, 0})
            .array();
    chunk(png, "IHDR", head);
    chunk(png, "IDAT", deflated(rows));
    chunk(png, "IEND", new byte[0]);
    return Base64.getEncoder().encodeToString(png.toByteArray());
  }

  private static byte[] deflated(byte[] rows) {
    try (Deflater deflater = new Deflater()) {
      deflater.setInput(rows);
      deflater.finish();
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      byte[] buffer = new byte[8192];
      while (!deflater.finished()) {
        out.write(buffer, 0, deflater.deflate(buffer));
      }
      return out.toByteArray();
    }
  }

  private static void chunk(ByteArrayOutputStream png, String name, byte[] data) {
    byte[] type = name.getBytes(StandardCharsets.US_ASCII);
    CRC32 sum = new CRC32();
    sum.update(type);
    sum.update(data);
    png.writeBytes(ByteBuffer.allocate(4).putInt(data.length).array());
    png.writeBytes(type);
    png.writeBytes(data);
    png.writeBytes(ByteBuffer.allocate(4).putInt((int) sum.getValue()).array());
  }
}
