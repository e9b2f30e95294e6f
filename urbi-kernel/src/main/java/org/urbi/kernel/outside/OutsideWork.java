package org.urbi.kernel.outside;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;

/** Something that is done for a job, with the limits of the job, on a thread of this package. */
final class OutsideWork<T> {
  /** The limits of the job for which a thread works. */
  private static final ScopedValue<Confinement> LENT = ScopedValue.newInstance();

  /** What kind of file it is, in the mode that the operating system tells (inode(7)). */
  private static final int KIND = 0170000;

  private static final int PIPE = 0010000;

  private final Confinement limits;
  private final @Nullable Path file;
  private final Callable<T> work;

  /** The thread that does the work; guarded by this object. */
  private @Nullable Thread doing;

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

  /** Does the work. */
  T call() throws Exception {
    begin(Thread.currentThread());
    try {
      return ScopedValue.where(LENT, limits).call(work::call);
    } finally {
      begin(null);
    }
  }

  private synchronized void begin(@Nullable Thread thread) {
    doing = thread;
    if (thread == null) {
      // What was to end this work must not end the next of its thread.
      Thread.interrupted();
    }
  }

  private synchronized boolean isUnderWay() {
    return doing != null;
  }

  private synchronized void interrupt() {
    if (doing != null) {
      doing.interrupt();
    }
  }

  boolean mayBeLetGo() {
    return file != null;
  }

  /**
   * Nobody waits for it any more: ends it, if it waits for those at the other end of a pipe, or for
   * a device, who may never come. What is done to regular files and folders is completed.
   */
  void letGo() {
    if (file == null || !isUnderWay()) {
      return;
    }
    try {
      Path real = limits.followed(file);
      int mode = (int) Files.getAttribute(real, "unix:mode");
      if (Files.isRegularFile(real) || Files.isDirectory(real)) {
        return;
      }
      interrupt();
      if ((mode & KIND) == PIPE) {
        // Who opens a pipe cannot be interrupted: for a moment there is somebody at the other end.
        new RandomAccessFile(real.toFile(), "rw").close();
      }
    } catch (IOException | UnsupportedOperationException e) {
      // The file is gone, or forbidden: the work ends when the operating system lets it.
    }
  }
}
