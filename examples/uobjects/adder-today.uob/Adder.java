import java.util.concurrent.CompletableFuture;
import urbi.OnChange;
import urbi.UEvent;
import urbi.UEventField;
import urbi.UFunction;
import urbi.UObject;
import urbi.UStart;
import urbi.UVar;
import urbi.UVariable;

/** The Adder with annotations: nothing is bound by hand. */
@UStart
public class Adder extends UObject {
  /** What {@link #describe} answers: a dictionary in urbiscript. */
  public record Sum(double left, double right, double total) {}

  @UVariable private final UVar v = UVar.of(42);
  @UEventField private UEvent negative;

  public Adder(String name) {
    super(name);
  }

  @UFunction
  public double add(double summand) {
    return v.doubleValue() + summand;
  }

  @UFunction
  public Sum describe(double summand) {
    return new Sum(v.doubleValue(), summand, add(summand));
  }

  /** The caller waits for the result, and everybody else goes on. */
  @UFunction
  public CompletableFuture<Double> addLater(double summand) {
    return CompletableFuture.supplyAsync(() -> add(summand));
  }

  @OnChange("v")
  void changed(double value) {
    if (value < 0) {
      negative.emit(value);
    }
  }
}
