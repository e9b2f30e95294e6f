import java.util.List;

/** Joins pieces, which takes its time; it knows nothing of Urbi. */
public class Machine {
  private final long milliseconds;

  public Machine(double seconds) {
    milliseconds = Math.round(seconds * 1000);
  }

  public String assemble(List<String> pieces) {
    try {
      Thread.sleep(milliseconds);
    } catch (InterruptedException e) {
      throw new IllegalStateException("the machine was interrupted", e);
    }
    return String.join("", pieces);
  }
}
