package org.urbi.bridge;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import urbi.UModuleException;

/** Says why a shared library cannot be loaded. */
final class LoaderErrors {
  private static final int ELF_MAGIC = 0x7f454c46;
  private static final int HEADER = 20;
  private static final int CLASS_OFFSET = 4;
  private static final int ORDER_OFFSET = 5;
  private static final int TYPE_OFFSET = 16;
  private static final int MACHINE_OFFSET = 18;
  private static final int BIG_ENDIAN = 2;
  private static final int SHARED = 3;

  private static final Map<Integer, String> MACHINES =
      Map.of(
          3, "i386",
          8, "mips",
          20, "powerpc",
          21, "ppc64",
          22, "s390x",
          40, "arm",
          62, "x86_64",
          183, "aarch64",
          243, "riscv64");

  private static final Map<String, String> JAVA_NAMES =
      Map.of("amd64", "x86_64", "ppc64le", "ppc64", "x86", "i386");

  private LoaderErrors() {}

  /**
   * Looks at the header of an ELF file, since the loader's own message about the wrong architecture
   * is that there is no such file.
   *
   * @throws UModuleException if it is for another machine, or is no shared library
   */
  static void checkHeader(Path file, String shown) {
    byte[] header;
    try (InputStream in = Files.newInputStream(file)) {
      header = in.readNBytes(HEADER);
    } catch (IOException e) {
      throw new UModuleException("cannot read " + shown + ": " + e.getMessage(), e);
    }
    if (!System.getProperty("os.name").equals("Linux")) {
      return;
    }
    ByteBuffer bytes = ByteBuffer.wrap(header);
    if (header.length < HEADER || bytes.getInt(0) != ELF_MAGIC) {
      throw new UModuleException("cannot load " + shown + ": it is no shared library");
    }
    if (header[ORDER_OFFSET] != BIG_ENDIAN) {
      bytes.order(ByteOrder.LITTLE_ENDIAN);
    }
    int number = bytes.getShort(MACHINE_OFFSET) & 0xffff;
    String machine = MACHINES.getOrDefault(number, "machine " + number);
    String arch = System.getProperty("os.arch");
    String own = JAVA_NAMES.getOrDefault(arch, arch);
    boolean wide = header[CLASS_OFFSET] == 2;
    if (!machine.equals(own) || wide != own.contains("64") && !own.equals("s390x")) {
      throw new UModuleException(
          "cannot load " + shown + ": it is for " + machine + ", and this is " + own);
    }
    if (bytes.getShort(TYPE_OFFSET) != SHARED) {
      throw new UModuleException("cannot load " + shown + ": it is no shared library");
    }
  }

  /** What the system's loader has to say, without what JNA adds to it. */
  static String text(Path file, String shown, @Nullable String message) {
    String reason = message == null ? "unknown reason" : message.strip();
    for (String line : reason.lines().toList()) {
      if (line.contains(file.toString()) && !line.startsWith("Unable to load library")) {
        reason = line;
        break;
      }
    }
    reason = reason.replace(file + ": ", "");
    return "cannot load " + shown + ": " + reason;
  }
}
