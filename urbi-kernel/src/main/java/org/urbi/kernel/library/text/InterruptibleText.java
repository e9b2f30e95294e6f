package org.urbi.kernel.library.text;

import org.urbi.kernel.job.Job;
import org.urbi.lang.grammar.Checkpoint;

/** A text whose matching can be interrupted: that may take exponential time. */
final class InterruptibleText implements CharSequence {
  private final String text;
  private final Checkpoint checkpoint;

  /**
   * @param job the one that matches
   */
  InterruptibleText(String text, Job job) {
    this(text, new Checkpoint(job::checkInterrupted));
  }

  private InterruptibleText(String text, Checkpoint checkpoint) {
    this.text = text;
    this.checkpoint = checkpoint;
  }

  @Override
  public char charAt(int index) {
    checkpoint.pass();
    return text.charAt(index);
  }

  @Override
  public int length() {
    checkpoint.pass();
    return text.length();
  }

  @Override
  public CharSequence subSequence(int start, int end) {
    return new InterruptibleText(text.substring(start, end), checkpoint);
  }

  @Override
  public String toString() {
    return text;
  }
}
