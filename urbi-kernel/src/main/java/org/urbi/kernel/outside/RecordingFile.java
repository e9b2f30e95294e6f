package org.urbi.kernel.outside;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Opens the file of a recording. It is named by the user of the machine, not by urbiscript code, so
 * it is not confined.
 */
public final class RecordingFile {
  private RecordingFile() {}

  /**
   * Creates the file, or empties it.
   *
   * @throws IOException if it cannot be written
   */
  public static OutputStream create(Path path) throws IOException {
    return Files.newOutputStream(path);
  }

  /**
   * Opens the file to be read.
   *
   * @throws IOException if there is none, or it must not be read
   */
  public static InputStream open(Path path) throws IOException {
    return new BufferedInputStream(Files.newInputStream(path));
  }
}
