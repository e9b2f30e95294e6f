package urbi;

import java.awt.FileDialog;
import java.io.IOException;
import javax.swing.JButton;
import javax.swing.JFrame;
import org.jspecify.annotations.Nullable;
import urbi.thread.GuardedThreads;

/** A window with a button that has a server play a file. */
@SuppressWarnings("this-escape") // It shows itself as soon as it is constructed.
public class SendSoundSampler extends JFrame {
  private static final long serialVersionUID = 1;

  private transient volatile @Nullable UClient client;

  /** Shows the window; {@link #setClient} says where the sound goes. */
  public SendSoundSampler() {
    this(null);
  }

  /** Shows the window. */
  public SendSoundSampler(@Nullable UClient client) {
    super("Send a sound");
    this.client = client;
    setDefaultCloseOperation(EXIT_ON_CLOSE);
    JButton play = new JButton("Play");
    play.addActionListener(event -> choose());
    add(play);
    pack();
    setVisible(true);
  }

  private void choose() {
    FileDialog dialog = new FileDialog(this);
    dialog.setVisible(true);
    if (dialog.getFile() != null) {
      String path = dialog.getDirectory() + dialog.getFile();
      GuardedThreads.SDK.platform("urbi-sound", () -> send(path)).start();
    }
  }

  private void send(String path) {
    UClient server = client;
    if (server == null) {
      Log.error("cannot send " + path + ": there is no server to send it to");
      return;
    }
    try {
      SoundUtilities.sendSound(path, server);
    } catch (IOException e) {
      Log.error("cannot send " + path + ": " + e.getMessage());
    }
  }

  public void setClient(UClient other) {
    client = other;
  }

  public @Nullable UClient getClient() {
    return client;
  }
}
