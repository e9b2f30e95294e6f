import urbi.UImage;
import urbi.UImageFormat;
import urbi.UObject;
import urbi.UVar;

/** A camera: whoever reads {@code camera.val} gets a picture, at most one per cycle of the kernel. */
public class Camera extends UObject {
  static {
    UStart(Camera.class);
  }

  private static final double PERIOD_MILLISECONDS = 1;

  private final UVar val = new UVar();
  private final UVar width = new UVar();
  private final UVar height = new UVar();
  private CameraDevice device;
  private long frame;
  private long lastAccess = -1;

  public Camera(String name) {
    super(name);
    UBindFunction("init");
  }

  /** {@code Camera.new(0)}; whatever the device throws becomes an exception in urbiscript. */
  public void init(int id) {
    device = CameraDevice.initialize(id);
    UBindVars(val, "val", width, "width", height, "height");
    width.setValue(device.width());
    height.setValue(device.height());
    UNotifyAccess(val, "getVal");
    USetUpdate(PERIOD_MILLISECONDS);
  }

  @Override
  public int update() {
    frame++;
    return 0;
  }

  /** Takes a picture, unless there is one of this cycle already: it may take long. */
  public void getVal() {
    if (frame == lastAccess) {
      return;
    }
    lastAccess = frame;
    // The device has one buffer for all pictures, and a variable keeps what it is given.
    byte[] picture = device.getImage().clone();
    val.setValue(new UImage(UImageFormat.IMAGE_RGB, device.width(), device.height(), picture));
  }
}
