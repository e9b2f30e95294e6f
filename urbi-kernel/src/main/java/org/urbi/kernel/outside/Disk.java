package org.urbi.kernel.outside;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;

/**
 * The files and directories that one kernel may use. All paths are absolute. Failures are {@link
 * IOException}s, forbidden operations {@link ConfinedException}s.
 */
public final class Disk {
  /** How many bytes are read at most of something that is not a regular file. */
  private static final int LARGEST_DEVICE = 1 << 26;

  /**
   * How many bytes are written at a time: the JDK copies them before it gives them to a channel.
   */
  private static final int CHUNK = 1 << 16;

  private final Outside outside;

  Disk(Outside outside) {
    this.outside = outside;
  }

  /** The limits of the calling code. */
  private Confinement confinement() {
    return outside.confinement();
  }

  private void change(Outside.Change change) throws IOException {
    outside.change(change);
  }

  // ------------------------------------------------------------------ looking

  /** Whether a file of that name exists; a dangling link does not count. */
  public boolean exists(Path path) throws IOException {
    return outside.query(() -> Files.exists(confinement().followed(path)));
  }

  /** Whether a file of that name exists; a dangling link counts. */
  public boolean hasEntry(Path path) throws IOException {
    return outside.query(() -> Files.exists(confinement().entry(path), LinkOption.NOFOLLOW_LINKS));
  }

  public boolean isDirectory(Path path) throws IOException {
    return outside.query(() -> Files.isDirectory(confinement().followed(path)));
  }

  public boolean isRegularFile(Path path) throws IOException {
    return outside.query(() -> Files.isRegularFile(confinement().followed(path)));
  }

  public boolean isReadable(Path path) throws IOException {
    return outside.query(() -> Files.isReadable(confinement().followed(path)));
  }

  public boolean isWritable(Path path) throws IOException {
    return outside.query(() -> Files.isWritable(confinement().followed(path)));
  }

  /** The real path of a file, with all links resolved. */
  public Path real(Path path) throws IOException {
    return outside.query(() -> confinement().followed(path).toRealPath());
  }

  /** The size of a file, in bytes. */
  public long size(Path path) throws IOException {
    return outside.query(() -> Files.size(confinement().followed(path)));
  }

  /** When it was last modified, in microseconds since 1970. */
  public long lastModified(Path path) throws IOException {
    return outside.query(
        () -> Files.getLastModifiedTime(confinement().followed(path)).to(TimeUnit.MICROSECONDS));
  }

  // ------------------------------------------------------------------ content

  /**
   * All bytes of a file.
   *
   * @param most how many bytes it may have at most, if it is not a regular one
   */
  public byte[] read(Path path, long most) throws IOException {
    return outside.query(() -> readWhole(confinement().followed(path), most));
  }

  /** Devices and pipes have no size, and may have no end. */
  private static byte[] readWhole(Path path, long most) throws IOException {
    if (Files.isRegularFile(path)) {
      return Files.readAllBytes(path);
    }
    int limit = (int) Math.min(LARGEST_DEVICE, most);
    try (InputStream in = waiting(path)) {
      byte[] bytes = in.readNBytes(limit);
      if (bytes.length == limit && in.read() >= 0) {
        throw new IOException(Problem.FILE_TOO_LARGE.text());
      }
      return bytes;
    }
  }

  /** Writes the content of a file, which is created if it does not exist. */
  public void write(Path path, byte[] bytes) throws IOException {
    change(() -> {
      try (FileChannel file =
          FileChannel.open(
              confinement().followed(path),
              StandardOpenOption.CREATE,
              StandardOpenOption.WRITE,
              StandardOpenOption.TRUNCATE_EXISTING)) {
        for (int from = 0; from < bytes.length; ) {
          from += file.write(ByteBuffer.wrap(bytes, from, Math.min(CHUNK, bytes.length - from)));
        }
      }
    });
  }

  /** The bytes of a regular file, one after the other. */
  public FileSource source(Path path) throws IOException {
    return new FileSource(
        outside,
        path,
        size(path) == 0,
        outside.open(
            () -> FileChannel.open(confinement().followed(path), StandardOpenOption.READ)));
  }

  /** Opens a regular file to append to it. */
  public FileSink sink(Path path) throws IOException {
    return new FileSink(
        outside,
        outside.open(() ->
            FileChannel.open(
                confinement().followed(path),
                StandardOpenOption.WRITE,
                StandardOpenOption.APPEND)));
  }

  /**
   * Opens a file whose readers may have to wait, such as a pipe; null in a replay. When it is
   * closed nobody waits any more.
   */
  public @Nullable InputStream input(Path path) throws IOException {
    return outside.open(() -> waiting(confinement().followed(path)));
  }

  /**
   * Unlike other streams, a channel lets those go who wait when it is closed, or they interrupted.
   */
  private static InputStream waiting(Path path) throws IOException {
    return Channels.newInputStream(FileChannel.open(path, StandardOpenOption.READ));
  }

  /** Opens for writing a file whose writers may have to wait, such as a pipe; null in a replay. */
  public @Nullable OutputStream output(Path path) throws IOException {
    return outside.open(() -> new FileOutputStream(confinement().followed(path).toFile(), true));
  }

  // ------------------------------------------------------------------ files

  /** Copies a file; the new name must not exist. */
  public void copy(Path from, Path to) throws IOException {
    change(() -> {
      Files.copy(confinement().followed(from), confinement().changed(to));
    });
  }

  /** Renames a file; an existing file of that name is replaced. */
  public void replace(Path from, Path to) throws IOException {
    change(() -> {
      Files.move(
          confinement().changed(from),
          confinement().changed(to),
          StandardCopyOption.REPLACE_EXISTING);
    });
  }

  /** Renames a file or directory; the new name must not exist. */
  public void move(Path from, Path to) throws IOException {
    change(() -> {
      Files.move(confinement().changed(from), confinement().changed(to));
    });
  }

  /** Deletes a file, or an empty directory. */
  public void delete(Path path) throws IOException {
    change(() -> {
      Files.delete(confinement().changed(path));
    });
  }

  // ------------------------------------------------------------------ directories

  /** Creates a directory; the name must not exist. */
  public void createDirectory(Path path) throws IOException {
    change(() -> {
      Files.createDirectory(confinement().changed(path));
    });
  }

  /** Creates a directory and its missing parents. */
  public void createDirectories(Path path) throws IOException {
    change(() -> {
      Files.createDirectories(confinement().followed(path));
    });
  }

  /**
   * The names of what is in a directory, in no order.
   *
   * @param most how many are wanted: there may be millions
   */
  public List<Path> names(Path path, int most) throws IOException {
    return outside.query(() -> DirectoryTree.names(confinement().followed(path), most));
  }

  public boolean isEmpty(Path path) throws IOException {
    return outside.query(() -> DirectoryTree.isEmpty(confinement().followed(path)));
  }

  /** The sizes of all files in it and its directories together, in bytes. */
  public long treeSize(Path path) throws IOException {
    return outside.query(() -> DirectoryTree.size(confinement().entry(path)));
  }

  /** Copies a directory and all that is in it; the new name must not exist. */
  public void copyTree(Path from, Path to) throws IOException {
    change(() -> {
      DirectoryTree.copy(confinement().entry(from), confinement().changed(to));
    });
  }

  /** Removes all that is in a directory, which must not be the root. */
  public void clear(Path path) throws IOException {
    change(() -> {
      Path directory = confinement().followed(path).toRealPath();
      checkNotRoot(directory);
      DirectoryTree.clear(directory);
    });
  }

  /** Removes a directory, which must not be the root, and all that is in it. */
  public void removeTree(Path path) throws IOException {
    change(() -> {
      Path directory = confinement().changed(path);
      checkNotRoot(directory.toRealPath());
      DirectoryTree.remove(directory);
    });
  }

  private static void checkNotRoot(Path directory) throws IOException {
    if (directory.getNameCount() == 0) {
      throw new IOException(Problem.IS_THE_ROOT.text());
    }
  }
}
