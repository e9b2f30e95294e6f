import java.util.List;
import urbi.LockMode;
import urbi.UObject;

/** Shows a {@link Machine} to Urbi. */
public class UMachine extends UObject {
  static {
    UStart(UMachine.class);
  }

  private Machine machine = new Machine(0);

  /** Called for the prototype, and then for every machine that urbiscript makes. */
  public UMachine(String name) {
    super(name);
    UBindFunctions("init", "assemble");
  }

  /** The constructor of urbiscript, {@code UMachine.new(1s)}. */
  public int init(double seconds) {
    machine = new Machine(seconds);
    // The same function a second time, on a thread of its own, one call after the other.
    UBindThreadedFunctionRename("assemble", "threadedAssemble", LockMode.LOCK_FUNCTION);
    return 0;
  }

  /** Puts parts together, {@code machine.assemble(["Hello, ", "World!"])}. */
  public String assemble(List<String> parts) throws InterruptedException {
    return machine.assemble(parts);
  }
}
