import urbi.UBinary;
import urbi.UObject;
import urbi.UVar;

/** Produces numbers, and images without a copy. */
public class Source extends UObject {
  static byte[] sent;
  static byte[] received;

  private UVar val = new UVar();
  private UVar image = new UVar();
  private int frame;

  public Source(String name) {
    super(name);
    UBindVar(val, "val");
    UBindVar(image, "image");
    image.setBypass(true);
    UBindFunctions("produce", "shoot", "start", "own", "copy");
  }

  public void produce(double value) {
    val.setValue(value);
  }

  /** Writes a binary; returns its first byte afterwards. */
  public int shoot() {
    sent = new byte[] {(byte) ++frame, 0, 0};
    image.setValue(new UBinary("rgb 1 1", sent));
    return sent[0];
  }

  public void start() {
    USetUpdate(40);
  }

  @Override
  public int update() {
    return shoot();
  }

  public void own() {
    UOwned(image);
  }

  public void copy() {
    image.setBypass(false);
  }
}
