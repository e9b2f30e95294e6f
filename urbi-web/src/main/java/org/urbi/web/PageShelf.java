package org.urbi.web;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.zip.CRC32C;
import java.util.zip.GZIPOutputStream;
import org.jspecify.annotations.Nullable;

/**
 * The files of pages, as they are served. They do not change while the server runs: each is read,
 * and packed, once. For one thread.
 */
final class PageShelf {
  /** Below it, packing saves nothing, in bytes. */
  private static final int SMALL = 1000;

  /**
   * A file.
   *
   * @param packed whether its content is packed, by gzip
   * @param version by which a browser asks whether it is still the same
   */
  record Served(byte[] content, boolean packed, String version) {}

  private record Name(Class<?> home, String file, boolean packed) {}

  private final Map<Name, Served> known = new HashMap<>();

  /**
   * A file beside a class, or {@code null} if there is none.
   *
   * @param packed whether whoever gets it can unpack gzip; what is small is left as it is
   * @throws IOException if it cannot be read
   */
  @Nullable Served find(Class<?> home, String file, boolean packed) throws IOException {
    Name name = new Name(home, file, packed);
    Served served = known.get(name);
    if (served == null) {
      try (InputStream content = home.getResourceAsStream(file)) {
        if (content == null) {
          return null;
        }
        served = serve(content.readAllBytes(), packed);
        known.put(name, served);
      }
    }
    return served;
  }

  private static Served serve(byte[] content, boolean mayPack) {
    boolean packed = mayPack && content.length >= SMALL;
    byte[] sent = packed ? pack(content) : content;
    CRC32C sum = new CRC32C();
    sum.update(sent);
    String version = HexFormat.of().toHexDigits((int) sum.getValue()) + "-" + sent.length;
    return new Served(sent, packed, '"' + version + '"');
  }

  private static byte[] pack(byte[] content) {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
      out.write(content);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return packed.toByteArray();
  }
}
