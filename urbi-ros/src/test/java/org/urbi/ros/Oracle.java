package org.urbi.ros;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.InterfaceFiles;

/** What ROS itself says: written by the programs in {@code src/test/oracles}. */
public final class Oracle {
  private Oracle() {}

  /** The lines of a file. */
  public static List<String> lines(String file) {
    try (InputStream in = Oracle.class.getResourceAsStream(file)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The built-in types, and those of ROS 2's own tests. */
  public static Definitions definitions(Dialect dialect) {
    Path share = Path.of("src/test/resources/org/urbi/ros/share");
    return new Definitions(dialect, new InterfaceFiles(List.of(share)));
  }
}
