package urbi;

/**
 * Listener for a {@link SoundSampler}. Each method but the second is called on a thread of its own.
 */
public interface SoundAction {
  /** Begins to record. */
  void captureAudio();

  /** Ends recording. */
  void stopAudio();

  /** Plays what was recorded. */
  void playAudio();

  /** Writes what was recorded to a file. */
  void saveAudio(String path);
}
