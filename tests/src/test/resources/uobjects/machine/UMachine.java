import java.util.ArrayList;
import java.util.List;
import urbi.LockMode;
import urbi.UList;
import urbi.UObject;
import urbi.UValue;

public class UMachine extends UObject {
  static {
    UStart(UMachine.class);
  }

  private Machine machine = new Machine(0);

  public UMachine(String name) {
    super(name);
    UBindFunction("init");
    bindAll();
  }

  public int init(double duration) {
    if (duration < 0) {
      return 1;
    }
    machine = new Machine(duration);
    bindAll();
    return 0;
  }

  private void bindAll() {
    UBindFunction("assemble");
    UBindThreadedFunctionRename("assemble", "threadedAssemble", LockMode.LOCK_FUNCTION);
  }

  public String assemble(UList input) {
    List<String> pieces = new ArrayList<>();
    for (UValue piece : input) {
      pieces.add(piece.stringValue());
    }
    return machine.assemble(pieces);
  }
}
