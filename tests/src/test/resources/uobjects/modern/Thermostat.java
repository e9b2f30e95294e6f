import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import urbi.Every;
import urbi.LockMode;
import urbi.OnAccess;
import urbi.OnChange;
import urbi.UEvent;
import urbi.UEventField;
import urbi.UFunction;
import urbi.UObject;
import urbi.UStart;
import urbi.UVar;
import urbi.UVariable;

/** Written with annotations and method references. */
@UStart
public class Thermostat extends UObject {
  @UVariable private UVar target = UVar.of(20);
  @UVariable private UVar heating;
  @UVariable("temperature") private UVar measured;
  @UEventField private UEvent reached;
  private double room = 15;

  public Thermostat(String name) {
    super(name);
    bind("celsius", this::celsius);
    bind("reset", this::reset);
    bind("between", this::between);
  }

  double celsius(double fahrenheit) {
    return (fahrenheit - 32) / 1.8;
  }

  void reset() {
    room = 15;
  }

  boolean between(double low, double high) {
    return low <= room && room <= high;
  }

  @UFunction("warmUp")
  double warm(double degrees) {
    room += degrees;
    return room;
  }

  @UFunction(threaded = true, lock = LockMode.LOCK_INSTANCE)
  String slowly(String text) throws InterruptedException {
    Thread.sleep(20);
    return text;
  }

  @UFunction
  CompletableFuture<Double> forecast(double hours) {
    return CompletableFuture.supplyAsync(
        () -> room - hours, CompletableFuture.delayedExecutor(20, TimeUnit.MILLISECONDS));
  }

  @UFunction
  CompletableFuture<Double> failLater() {
    return CompletableFuture.failedFuture(new IllegalStateException("no forecast"));
  }

  @OnChange("target")
  void targetChanged(double degrees) {
    heating.setValue(degrees > room);
  }

  @OnAccess("temperature")
  void measure() {
    measured.setValue(room);
  }

  @Every(100)
  void drift() {
    if (heating.getUValue().isVoid() || !heating.booleanValue()) {
      return;
    }
    room += 1;
    if (room >= target.doubleValue()) {
      heating.setValue(false);
      reached.emit(room);
    }
  }
}
