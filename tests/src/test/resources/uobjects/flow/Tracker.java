import urbi.InputPort;
import urbi.LockMode;
import urbi.LockSpec;
import urbi.UBinary;
import urbi.UObject;
import urbi.UVar;

/** Takes what is led into its port, and tells what it has made of it. */
public class Tracker extends UObject {
  static {
    UStart(Tracker.class);
    UStart(Source.class);
  }

  private InputPort input = new InputPort();
  private UVar val = new UVar();
  private UVar threadedInput = new UVar();
  private UVar slowly = new UVar();
  private UVar dropped = new UVar();

  public Tracker(String name) {
    super(name);
    UBindVar(input, "input");
    UBindVars(val, "val", threadedInput, "threadedInput", slowly, "slowly", dropped, "dropped");
    UNotifyChange(input, "onInput");
    UNotifyThreadedChange(threadedInput, "onThread", LockMode.LOCK_FUNCTION);
    UNotifyThreadedChange(slowly, "onThreadSlowly", LockMode.LOCK_FUNCTION);
    UNotifyThreadedChange(dropped, "onThreadSlowly", LockSpec.LOCK_FUNCTION_DROP);
    UBindFunction("received");
  }

  public void onInput(UVar v) {
    switch (v.type()) {
      case DATA_BINARY -> {
        UBinary binary = v.ubinaryValue();
        Source.received = binary.getData();
        val.setValue(binary.getMessage() + " " + binary.getSize());
      }
      default -> val.setValue("got " + v.getUValue());
    }
  }

  public void onThread(double value) {
    val.setValue(Thread.currentThread().isVirtual() ? "not on a thread" : "thread " + (int) value);
  }

  public void onThreadSlowly(double value) throws InterruptedException {
    Thread.sleep(30);
    val.setValue("slow " + (int) value);
  }

  public boolean received() {
    return Source.received == Source.sent;
  }
}
