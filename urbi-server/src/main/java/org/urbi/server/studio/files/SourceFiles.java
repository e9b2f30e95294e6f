package org.urbi.server.studio.files;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;

/**
 * The files of urbiscript in a directory and those below it, for people who edit them. Links are
 * not followed out of it. A file that somebody else has changed meanwhile is not overwritten; for
 * that, one thing is to be done after the other.
 */
public final class SourceFiles {
  /** How many bytes a file may have. */
  public static final int LONGEST = 1 << 17;

  private static final String SUFFIX = ".u";
  private static final int DEEPEST = 8;
  private static final int MOST_LISTED = 1000;

  /** Of how many files it is looked at whether they are of urbiscript. */
  private static final int MOST_SEEN = 20_000;

  /**
   * A file as it is now.
   *
   * @param version changes with the text
   */
  public record Content(String text, String version) {}

  private final Path folder;

  SourceFiles(Path folder) {
    this.folder = folder;
  }

  /**
   * The names of the files, in alphabetical order: {@code walk/left.u}. Of very many, not all.
   *
   * @throws FileRefused if there is no such directory
   */
  public List<String> list() throws FileRefused {
    List<String> names = new ArrayList<>();
    try {
      Path root = folder.toRealPath();
      Files.walkFileTree(root, Set.of(), DEEPEST, new Listing(root, names));
    } catch (IOException e) {
      throw new FileRefused("the directory cannot be read: " + reason(e));
    }
    names.sort(null);
    return names;
  }

  private static final class Listing extends SimpleFileVisitor<Path> {
    private final Path root;
    private final List<String> names;
    private int seen;

    Listing(Path root, List<String> names) {
      this.root = root;
      this.names = names;
    }

    @Override
    public FileVisitResult preVisitDirectory(Path directory, BasicFileAttributes attributes) {
      boolean hidden =
          !directory.equals(root) && directory.getFileName().toString().startsWith(".");
      return hidden ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      if (attributes.isRegularFile() && file.getFileName().toString().endsWith(SUFFIX)) {
        names.add(root.relativize(file).toString());
      }
      return ++seen < MOST_SEEN && names.size() < MOST_LISTED
          ? FileVisitResult.CONTINUE
          : FileVisitResult.TERMINATE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException unreadable) throws IOException {
      if (file.equals(root)) {
        throw unreadable;
      }
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path directory, IOException unreadable) {
      return FileVisitResult.CONTINUE;
    }
  }

  /**
   * Reads a file.
   *
   * @throws FileRefused if it is not there, too large, no text, or not to be read
   */
  public Content open(String name) throws FileRefused {
    byte[] bytes;
    try {
      bytes = bytes(name, place(name));
    } catch (NoSuchFileException e) {
      throw new FileRefused(name + ": no such file any more");
    } catch (IOException e) {
      throw new FileRefused(name + " cannot be read: " + reason(e));
    }
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      if (text.indexOf('\0') >= 0) {
        throw new CharacterCodingException();
      }
      return new Content(text, version(bytes));
    } catch (CharacterCodingException e) {
      throw new FileRefused(name + " is no text in UTF-8");
    }
  }

  /**
   * Writes a file, at once or not at all.
   *
   * @param version of which the text has been made; empty if it is to be a new file
   * @return its version now
   * @throws FileRefused if it is not what it was, or not to be written
   */
  public String save(String name, String text, String version) throws FileRefused {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    if (bytes.length > LONGEST) {
      throw tooLarge(name, bytes.length);
    }
    try {
      Path file = place(name);
      if (!Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
        create(name, file, bytes, version);
      } else if (version.isEmpty()) {
        throw new FileRefused(name + " is there already: open it first, or choose another name");
      } else if (!version(bytes(name, file)).equals(version)) {
        throw new FileRefused(
            name + " has been changed meanwhile: open it again, or choose another name");
      } else {
        replace(file, bytes);
      }
      return version(bytes);
    } catch (IOException e) {
      throw new FileRefused(name + " cannot be written: " + reason(e));
    }
  }

  private static void create(String name, Path file, byte[] bytes, String version)
      throws IOException, FileRefused {
    if (!version.isEmpty()) {
      throw new FileRefused(name + " has been deleted meanwhile: save it again to have it anew");
    }
    boolean complete = false;
    try {
      Files.write(file, bytes, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      complete = true;
    } finally {
      if (!complete) {
        Files.deleteIfExists(file);
      }
    }
  }

  private static void replace(Path file, byte[] bytes) throws IOException {
    Path part = Files.createTempFile(file.getParent(), "." + file.getFileName(), ".part");
    try {
      Files.write(part, bytes);
      Files.setPosixFilePermissions(part, Files.getPosixFilePermissions(file));
      Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(part);
    }
  }

  /** Where a file is: below the directory, also when links are followed, and no link itself. */
  private Path place(String name) throws IOException, FileRefused {
    if (name.isBlank()) {
      throw new FileRefused("give the file a name that ends in " + SUFFIX);
    }
    try {
      Path root = folder.toRealPath();
      Path path = root.resolve(name).normalize();
      if (path.startsWith(root) && !path.equals(root) && name.endsWith(SUFFIX)) {
        Path parent = requireNonNull(path.getParent(), "it is below the root").toRealPath();
        Path file = parent.resolve(path.getFileName());
        if (parent.startsWith(root) && !Files.isSymbolicLink(file)) {
          return file;
        }
      }
    } catch (InvalidPathException e) {
      // As what follows.
    }
    throw new FileRefused(
        name + ": only files below the directory that end in " + SUFFIX + ", and no links");
  }

  private static byte[] bytes(String name, Path file) throws IOException, FileRefused {
    BasicFileAttributes attributes =
        Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    if (!attributes.isRegularFile()) {
      throw new FileRefused(name + " is no file");
    }
    try (InputStream in = Files.newInputStream(file, LinkOption.NOFOLLOW_LINKS)) {
      byte[] bytes = in.readNBytes(LONGEST + 1);
      if (bytes.length > LONGEST) {
        throw tooLarge(name, attributes.size());
      }
      return bytes;
    }
  }

  private static FileRefused tooLarge(String name, long bytes) {
    return new FileRefused(name + " is too large: " + bytes + " bytes, at most " + LONGEST);
  }

  private static String version(byte[] bytes) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has it", e);
    }
  }

  /** The paths of the server are nobody's business. */
  private static String reason(IOException e) {
    return e instanceof FileSystemException failure && failure.getReason() != null
        ? failure.getReason()
        : switch (e) {
          case NoSuchFileException missing -> "no such directory";
          case AccessDeniedException denied -> "permission denied";
          default -> e.getClass().getSimpleName();
        };
  }
}
