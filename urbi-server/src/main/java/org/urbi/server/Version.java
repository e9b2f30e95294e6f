package org.urbi.server;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Properties;
import org.urbi.kernel.library.system.Dialect;

/** What {@code --version} answers. */
public final class Version {
  private Version() {}

  /** The version number of this build: that of the software, not of the language. */
  public static String number() {
    Properties properties = new Properties();
    try (InputStream in = Version.class.getResourceAsStream("version.properties")) {
      properties.load(in);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return properties.getProperty("version");
  }

  /** The lines that {@code program --version} prints. */
  public static String text(String program) {
    return program
        + " version "
        + number()
        + " (Urbi on the JVM), urbiscript of Urbi "
        + Dialect.VERSION
        + "\n"
        + "Copyright (C) 2026 the Urbi on the JVM authors.\n"
        + "Java "
        + Runtime.version()
        + "\n";
  }
}
