package org.urbi.server.net;

import static java.nio.file.LinkOption.NOFOLLOW_LINKS;
import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.READ;
import static java.nio.file.StandardOpenOption.WRITE;

import java.io.IOException;
import java.net.ConnectException;
import java.net.SocketException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;

/**
 * The file of a Unix domain socket that a server listens on. Whoever may write the file may
 * connect: it appears with its permissions, never with others, and only when the server listens.
 */
final class UnixSocketFile implements AutoCloseable {
  private static final Set<PosixFilePermission> MINE_ALONE =
      PosixFilePermissions.fromString("rwx------");

  private static final FileAttribute<?> MINE_TO_WRITE =
      PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"));

  /** To write alone would wait for a reader, if somebody has put a pipe there. */
  private static final Set<OpenOption> TO_LOCK = Set.of(CREATE, READ, WRITE, NOFOLLOW_LINKS);

  /** The most that Linux takes; macOS takes 104. */
  private static final int MAX_BYTES = 107;

  /** After so many names that are taken it gives up; processes that were killed leave theirs. */
  private static final int MAX_FOLDERS = 100;

  private static final int TYPE = 0170000;
  private static final int SOCKET = 0140000;

  private final Path file;
  private final ServerSocketChannel channel;
  private final Object key;

  private UnixSocketFile(Path file, ServerSocketChannel channel) throws IOException {
    this.file = file;
    this.channel = channel;
    key = key(file);
  }

  /**
   * Listens. The socket of a server that has gone is replaced; nothing else is.
   *
   * @param backlog how many clients may wait to be let in
   * @throws IOException if that is not possible; the message says why
   */
  static UnixSocketFile listen(Path file, Set<PosixFilePermission> permissions, int backlog)
      throws IOException {
    // A process in another folder finds what this one has made; and so does this one, if it moves.
    Path where = file.toAbsolutePath();
    try {
      return listenAt(where, permissions, backlog);
    } catch (NoSuchFileException e) {
      throw failed(file, "there is no folder " + where.getParent(), e);
    } catch (FileAlreadyExistsException e) {
      throw failed(file, "somebody else is just making it", e);
    } catch (IOException | UnsupportedOperationException e) {
      throw failed(file, reason(e), e);
    }
  }

  private static String reason(Exception e) {
    return e instanceof java.nio.file.AccessDeniedException denied
        ? "permission denied: " + denied.getFile()
        : String.valueOf(e.getMessage());
  }

  private static IOException failed(Path file, String reason, Exception cause) {
    return new IOException("cannot listen on the socket " + file + ": " + reason, cause);
  }

  private static UnixSocketFile listenAt(
      Path file, Set<PosixFilePermission> permissions, int backlog) throws IOException {
    refuseUnlessStale(file);
    refuseIfTooLong(file);
    // Nobody can reach the socket here before it has its permissions.
    Path folder = privateFolder(file);
    Path made = folder.resolve("s");
    ServerSocketChannel channel = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
    try {
      channel.bind(UnixDomainSocketAddress.of(made), backlog);
      Files.setPosixFilePermissions(made, permissions);
      place(made, file, folder.resolve("o"));
      return new UnixSocketFile(file, channel);
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    } finally {
      Files.deleteIfExists(made);
      Files.deleteIfExists(folder.resolve("o"));
      Files.delete(folder);
    }
  }

  /** A new folder beside a file, with a short name. */
  private static Path privateFolder(Path file) throws IOException {
    for (int i = 0; ; i++) {
      Path folder = file.resolveSibling(".%x.%x".formatted(ProcessHandle.current().pid(), i));
      refuseIfTooLong(folder.resolve("s"));
      try {
        return Files.createDirectory(folder, PosixFilePermissions.asFileAttribute(MINE_ALONE));
      } catch (FileAlreadyExistsException e) {
        if (i == MAX_FOLDERS) {
          throw e;
        }
      }
    }
  }

  private static void refuseIfTooLong(Path file) throws IOException {
    int length = file.toString().getBytes(StandardCharsets.UTF_8).length;
    if (length > MAX_BYTES) {
      throw new IOException(
          "the path has " + (length - MAX_BYTES) + " bytes too many for a socket");
    }
  }

  /** Of those that start at the same time where nothing is, one wins without a lock. */
  private static void place(Path made, Path file, Path old) throws IOException {
    if (Files.exists(file, NOFOLLOW_LINKS)) {
      replace(made, file, old);
    } else {
      Files.createLink(file, made);
    }
  }

  /**
   * One at a time: between the look at a stale socket and its removal somebody else would put a
   * live one there. The lock goes with the process that has it, however that ends, and a file of it
   * that is left behind hinders nobody. Who gets the lock of a file that is no more finds the live
   * socket of the one that has removed it.
   */
  private static synchronized void replace(Path made, Path file, Path old) throws IOException {
    Path beside = file.resolveSibling("." + file.getFileName() + ".urbi-lock");
    try (FileChannel channel = lockFile(beside)) {
      if (isLocked(channel)) {
        throw new IOException("somebody else is just replacing it, and has locked " + beside);
      }
      try {
        refuseUnlessStale(file);
        removeStale(file, old);
        Files.createLink(file, made);
      } finally {
        Files.deleteIfExists(beside);
      }
    }
  }

  private static FileChannel lockFile(Path beside) throws IOException {
    try {
      return FileChannel.open(beside, TO_LOCK, MINE_TO_WRITE);
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      // That there is a symbolic link in its place is told without its name.
      throw new IOException(beside + ": " + e.getMessage(), e);
    }
  }

  /** Whether somebody else has the lock; if not, it is taken, until the channel is closed. */
  private static boolean isLocked(FileChannel channel) throws IOException {
    try {
      return channel.tryLock() == null;
    } catch (OverlappingFileLockException e) {
      return true;
    } catch (IOException e) {
      throw new IOException(
          "it is there, and nobody can be kept from replacing it too ("
              + e.getMessage()
              + "): remove it if no server listens there",
          e);
    }
  }

  /** Whoever does not know of the lock may start, too: what was taken away is looked at again. */
  private static void removeStale(Path file, Path old) throws IOException {
    try {
      Files.move(file, old);
    } catch (NoSuchFileException e) {
      return;
    }
    try {
      refuseUnlessStale(old);
    } catch (IOException e) {
      Files.createLink(file, old);
      throw e;
    }
  }

  private static void refuseUnlessStale(Path file) throws IOException {
    if (!Files.exists(file, NOFOLLOW_LINKS)) {
      return;
    }
    int mode = (int) Files.getAttribute(file, "unix:mode", NOFOLLOW_LINKS);
    if ((mode & TYPE) != SOCKET) {
      throw new IOException("it is there, and is no socket");
    }
    try (SocketChannel probe = SocketChannel.open(StandardProtocolFamily.UNIX)) {
      // If the queue of that server is full, a blocking one would wait.
      probe.configureBlocking(false);
      probe.connect(UnixDomainSocketAddress.of(file));
    } catch (ConnectException e) {
      return;
    } catch (SocketException e) {
      throw new IOException("somebody else has it: " + e.getMessage(), e);
    }
    throw new IOException("a server listens there already");
  }

  private static Object key(Path file) throws IOException {
    return Files.readAttributes(file, BasicFileAttributes.class, NOFOLLOW_LINKS).fileKey();
  }

  /** Where clients are accepted. */
  ServerSocketChannel channel() {
    return channel;
  }

  /** Where it is, absolute. */
  Path path() {
    return file;
  }

  /** Removes the file, unless it is somebody else's by now. Clients that are connected stay so. */
  @Override
  public void close() throws IOException {
    channel.close();
    try {
      if (key(file).equals(key)) {
        Files.delete(file);
      }
    } catch (NoSuchFileException e) {
      // Somebody else has removed it.
    }
  }
}
