package org.urbi.server.cli;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.server.studio.RecordedFiles;
import org.urbi.server.studio.mcap.McapRecorder;

/**
 * The file to which a run records its variables, one at a time. Nobody holds its monitor while a
 * disk is waited for: who ends the process, perhaps on the kernel's thread, has to pass.
 */
final class VariablesFile {
  /** Begins to record. */
  interface Opening {
    McapRecorder open() throws IOException;
  }

  private final RecordedFiles shown;

  /** Null if nothing is recorded; before it is open, there is no recorder. */
  private @Nullable Path file;

  private @Nullable McapRecorder recorder;
  private boolean ended;

  /**
   * @param shown tells others which file it is
   */
  VariablesFile(RecordedFiles shown) {
    this.shown = shown;
  }

  /**
   * Begins a file.
   *
   * @throws IOException if it cannot be written, or there is one
   */
  void begin(Path wanted, Opening opening) throws IOException {
    McapRecorder broken = reserve(wanted);
    if (broken != null) {
      broken.close();
    }
    try {
      if (opened(wanted, opening.open())) {
        end();
      }
    } catch (IOException e) {
      String reason = e instanceof NoSuchFileException ? "no such directory" : FileAccess.reason(e);
      throw new IOException("cannot write the recording " + wanted + ": " + reason, e);
    } finally {
      release();
    }
  }

  /** Nobody else begins one from now on; returns one that the disk has ended. */
  private synchronized @Nullable McapRecorder reserve(Path wanted) throws IOException {
    if (ended) {
      throw new IOException("the server ends");
    }
    McapRecorder present = recorder;
    if (file != null && (present == null || present.goesOn())) {
      throw new IOException("variables are being recorded already, to " + file);
    }
    file = wanted;
    recorder = null;
    return present;
  }

  /** Returns whether the run has ended meanwhile. */
  private synchronized boolean opened(Path wanted, McapRecorder begun) {
    recorder = begun;
    shown.begin(wanted);
    // The disk may have ended it before that was told.
    if (!begun.goesOn()) {
      shown.end();
    }
    return ended;
  }

  /** If it could not be opened there is none. */
  private synchronized void release() {
    if (recorder == null) {
      file = null;
    }
  }

  /**
   * Completes the file; may wait for the disk and the kernel, so not on the kernel's thread.
   *
   * @throws IOException if there is none
   */
  void complete() throws IOException {
    McapRecorder present = recorder();
    if (present == null) {
      throw new IOException("no variables are being recorded");
    }
    present.stop();
    forget(present);
  }

  /** Completes the file, if there is one and the disk takes it; no other one is begun. */
  void end() {
    McapRecorder present = last();
    if (present != null) {
      present.closeOrAbandon();
      forget(present);
    }
  }

  private synchronized @Nullable McapRecorder last() {
    ended = true;
    return recorder;
  }

  private synchronized @Nullable McapRecorder recorder() {
    return recorder;
  }

  private synchronized void forget(McapRecorder completed) {
    if (recorder == completed) {
      recorder = null;
      file = null;
      shown.end();
    }
  }
}
