package org.urbi.server.console;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.Set;
import java.util.function.Consumer;
import org.jline.reader.LineReader;
import org.jline.reader.impl.history.DefaultHistory;

/**
 * The statements that were typed, each whole, in a file that nobody else can read. When the file
 * cannot be read or written, that is told once, and they are remembered until the end of the
 * session.
 */
final class StatementHistory extends DefaultHistory {
  /** Longer ones were not typed. */
  private static final int LONGEST = 1 << 16;

  private static final FileAttribute<Set<PosixFilePermission>> OWN_FOLDER =
      PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"));

  private static final Set<PosixFilePermission> OWN = PosixFilePermissions.fromString("rw-------");

  private final Path file;
  private final Consumer<String> told;
  private boolean failed;

  /**
   * @param told told, in a sentence, why statements are not kept
   */
  StatementHistory(Path file, Consumer<String> told) {
    this.file = file;
    this.told = told;
  }

  /** Where the user's history is, unless the environment says so another place. */
  static Path userFile() {
    String state = System.getenv("XDG_STATE_HOME");
    if (state != null && !state.isEmpty()) {
      return Path.of(state, "urbi", "history");
    }
    String home = System.getenv("HOME");
    return Path.of(home == null ? System.getProperty("user.home") : home, ".urbi_history");
  }

  @Override
  public void attach(LineReader reader) {
    reader.setVariable(LineReader.HISTORY_FILE, file);
    super.attach(reader);
  }

  @Override
  public void load() {
    try {
      prepare();
      super.load();
    } catch (IOException | UncheckedIOException | IllegalArgumentException e) {
      fail("cannot read the history", e);
    }
  }

  /** Makes the file if there is none, and lets nobody else read it. */
  private void prepare() throws IOException {
    Path folder = file.toAbsolutePath().getParent();
    if (folder != null && !Files.isDirectory(folder)) {
      Files.createDirectories(folder, OWN_FOLDER);
    }
    try {
      Files.createFile(file, PosixFilePermissions.asFileAttribute(OWN));
    } catch (FileAlreadyExistsException e) {
      boolean plain = Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
      if (plain && !Files.getPosixFilePermissions(file).equals(OWN)) {
        Files.setPosixFilePermissions(file, OWN);
      }
    }
  }

  @Override
  public void add(Instant time, String statements) {
    if (statements.length() <= LONGEST) {
      super.add(time, statements);
    }
  }

  @Override
  public void save() {
    if (!failed) {
      try {
        super.save();
      } catch (IOException | IllegalArgumentException e) {
        fail("cannot write the history", e);
      }
    }
  }

  private void fail(String what, Exception failure) {
    failed = true;
    told.accept(what + ", it is kept until the end of this session only: " + failure.getMessage());
  }
}
