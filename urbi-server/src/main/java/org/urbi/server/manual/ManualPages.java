package org.urbi.server.manual;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.urbi.server.cli.UrbiCommand;
import org.urbi.server.launch.UrbiLaunch;
import org.urbi.server.launch.UrbiLaunchJava;
import org.urbi.server.make.NewComponent;
import org.urbi.server.make.UmakeJava;
import org.urbi.server.options.Program;
import org.urbi.server.tools.UrbiCertificate;
import org.urbi.server.tools.UrbiImage;
import org.urbi.server.tools.UrbiPing;
import org.urbi.server.tools.UrbiSend;
import org.urbi.server.tools.UrbiSound;

/**
 * Writes the manual pages and completions of all programs into a folder {@code share}, where {@code
 * man} and shells look for them.
 */
public final class ManualPages {
  /** A program, as it is run. */
  private interface Run {
    int run(String[] args, PrintStream out, PrintStream err);
  }

  private static final Map<String, Run> PROGRAMS =
      new TreeMap<>(
          Map.of(
              "urbi", UrbiCommand::run,
              "urbi-new", NewComponent::run,
              "urbi-send", UrbiSend::run,
              "urbi-ping", UrbiPing::run,
              "urbi-image", UrbiImage::run,
              "urbi-sound", UrbiSound::run,
              "urbi-certificate", UrbiCertificate::run,
              "urbi-launch", UrbiLaunch::run,
              "urbi-launch-java", UrbiLaunchJava::run,
              "umake-java", UmakeJava::run));

  private ManualPages() {}

  /**
   * @param args the folder
   * @throws IOException if it cannot be written to
   */
  public static void main(String[] args) throws IOException {
    Path share = Path.of(args[0]);
    for (Map.Entry<String, Run> program : PROGRAMS.entrySet()) {
      String name = program.getKey();
      write(program.getValue(), "man", share.resolve("man/man1/" + name + ".1"));
      write(program.getValue(), "bash", share.resolve("bash-completion/completions/" + name));
      write(program.getValue(), "zsh", share.resolve("zsh/site-functions/_" + name));
    }
  }

  private static void write(Run program, String what, Path file) throws IOException {
    Files.createDirectories(file.getParent());
    try (PrintStream out =
        new PrintStream(Files.newOutputStream(file), false, StandardCharsets.UTF_8)) {
      int status = program.run(new String[] {Program.GENERATE + what}, out, System.err);
      if (status != 0 || out.checkError()) {
        throw new IOException("cannot write " + file);
      }
    }
  }
}
