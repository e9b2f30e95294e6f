package org.urbi.kernel.outside;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;

/** Something that is done for a job, with the limits of the job, on a thread of this package. */
final class OutsideWork<T> {
  /** The limits of the job for which a thread works. */
  private static final ScopedValue<Confinement> LENT = ScopedValue.newInstance();

  /** What kind of file it is, in the mode that the operating system tells (inode(7)). */
  private static final int KIND = 0170000;

  private static final int PIPE = 0010000;

  /** How long is waited at most before it is tried again to end the work, in milliseconds. */
  private static final int LONGEST_PAUSE = 512;

  private final Confinement limits;
  private final @Nullable Path file;
  private final Callable<T> work;

  /** The thread that does the work; guarded by this object. */
  private @Nullable Thread doing;

  /** Whether it is not to begin any more; guarded by this object. */
  private boolean letGo;

  /**
   * @param file what it is about, if it is to end with the job where that file makes it wait for
   *     others
   */
  OutsideWork(Confinement limits, @Nullable Path file, Callable<T> work) {
    this.limits = limits;
    this.file = file;
    this.work = work;
  }

  /** The limits of the job for which this thread works; null if it does not work for one. */
  static @Nullable Confinement confinement() {
    return LENT.isBound() ? LENT.get() : null;
  }

  /**
   * Does the work.
   *
   * @throws InterruptedIOException if it was let go before it began
   */
  T call() throws Exception {
    begin();
    try {
      return ScopedValue.where(LENT, limits).call(work::call);
    } finally {
      end();
    }
  }

  private synchronized void begin() throws InterruptedIOException {
    if (letGo) {
      throw new InterruptedIOException();
    }
    doing = Thread.currentThread();
  }

  private synchronized void end() {
    doing = null;
    // What was to end this work must not end the next of its thread.
    Thread.interrupted();
    notifyAll();
  }

  boolean mayBeLetGo() {
    return file != null;
  }

  /**
   * Nobody waits for it any more: ends it, if it waits for those at the other end of a pipe, or for
   * a device, who may never come. What is done to regular files and folders is completed.
   */
  void letGo() throws InterruptedException {
    if (file == null) {
      return;
    }
    try {
      Path real = limits.followed(file);
      int mode = (int) Files.getAttribute(real, "unix:mode");
      if (!Files.isRegularFile(real) && !Files.isDirectory(real)) {
        letGo(real, (mode & KIND) == PIPE);
      }
    } catch (IOException | UnsupportedOperationException e) {
      // The file is gone, or forbidden: the work ends when the operating system lets it.
    }
  }

  /** It may be about to wait, which nobody can see, so it is tried some times. */
  private synchronized void letGo(Path real, boolean pipe)
      throws IOException, InterruptedException {
    letGo = true;
    for (int pause = 1; doing != null && pause <= LONGEST_PAUSE; pause *= 2) {
      doing.interrupt();
      if (pipe) {
        // Who opens a pipe cannot be interrupted: for a moment there is somebody at the other end.
        FileChannel.open(real, StandardOpenOption.READ, StandardOpenOption.WRITE).close();
      }
      wait(pause);
    }
  }
}
