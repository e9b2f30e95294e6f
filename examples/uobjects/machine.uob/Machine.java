import java.util.List;

/** An assembly machine: it puts parts together, which takes some time. Nothing here knows Urbi. */
public class Machine {
  private final double seconds;

  /** A machine that needs so many seconds for an assembly. */
  public Machine(double seconds) {
    this.seconds = seconds;
  }

  /** Puts the parts together, one behind the other. */
  public String assemble(List<String> parts) throws InterruptedException {
    Thread.sleep(Math.round(seconds * 1000));
    return String.join("", parts);
  }
}
