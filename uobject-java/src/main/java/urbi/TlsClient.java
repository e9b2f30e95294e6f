package urbi;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.CertPathBuilderException;
import java.security.cert.CertPathValidatorException;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateFactory;
import java.security.cert.CertificateNotYetValidException;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManagerFactory;
import org.jspecify.annotations.Nullable;

/** TLS to a server, whose certificate must be for the name that was asked for. */
final class TlsClient {
  private static final String VERSION = "TLSv1.3";
  private static final Set<String> NO = Set.of("", "0", "no", "false", "off");

  /** How long closing may wait for a server that does not read. */
  private static final int FAREWELL_SECONDS = 1;

  private TlsClient() {}

  /** Whether the process is to connect by TLS. */
  static boolean isWanted() {
    String wanted = setting(ServerConnection.TLS_PROPERTY, "URBI_TLS");
    return wanted == null ? trusted() != null : !NO.contains(wanted.toLowerCase(Locale.ROOT));
  }

  private static @Nullable String trusted() {
    String file = setting(ServerConnection.TLS_CA_PROPERTY, "URBI_TLS_CA");
    return file == null || file.isEmpty() ? null : file;
  }

  private static @Nullable String setting(String property, String variable) {
    return System.getProperty(property, System.getenv(variable));
  }

  /**
   * Makes TLS of a connection.
   *
   * @param milliseconds how long the server may be silent meanwhile
   * @throws IOException if that cannot be; the message says why, and what to do
   */
  static Socket secure(Socket plain, String host, int port, int milliseconds) throws IOException {
    // Else a server that does not read would have close() wait for ever.
    plain.setSoLinger(true, FAREWELL_SECONDS);
    SSLSocket tls =
        (SSLSocket) context(trusted()).getSocketFactory().createSocket(plain, host, port, true);
    SSLParameters parameters = tls.getSSLParameters();
    parameters.setProtocols(new String[] {VERSION});
    parameters.setEndpointIdentificationAlgorithm("HTTPS");
    tls.setSSLParameters(parameters);
    tls.setSoTimeout(milliseconds);
    try {
      tls.startHandshake();
      // The JDK does not look at the dates of one that is trusted by itself.
      ((X509Certificate) tls.getSession().getPeerCertificates()[0]).checkValidity();
    } catch (IOException | CertificateException e) {
      throw new IOException(reason(e), e);
    }
    tls.setSoTimeout(0);
    return tls;
  }

  private static SSLContext context(@Nullable String file) throws IOException {
    try {
      if (file == null) {
        return SSLContext.getDefault();
      }
      KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
      store.load(null, null);
      for (Certificate each : certificates(Path.of(file))) {
        store.setCertificateEntry(String.valueOf(store.size()), each);
      }
      TrustManagerFactory trust =
          TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
      trust.init(store);
      SSLContext context = SSLContext.getInstance("TLS");
      context.init(null, trust.getTrustManagers(), null);
      return context;
    } catch (GeneralSecurityException e) {
      throw new IOException("no TLS: " + e.getMessage(), e);
    }
  }

  private static List<Certificate> certificates(Path file) throws IOException {
    Collection<? extends Certificate> found;
    try (InputStream in = Files.newInputStream(file)) {
      found = CertificateFactory.getInstance("X.509").generateCertificates(in);
    } catch (IOException e) {
      throw new IOException("cannot read the certificate to be trusted, " + file, e);
    } catch (CertificateException e) {
      throw new IOException("no certificate in PEM: " + file, e);
    }
    if (found.isEmpty()) {
      throw new IOException("no certificate in PEM: " + file);
    }
    return List.copyOf(found);
  }

  /** What a user can do something with. */
  private static String reason(Exception failure) {
    String message = String.valueOf(failure.getMessage());
    if (has(failure, CertificateExpiredException.class)) {
      return "the server's certificate has expired, it needs a new one";
    }
    if (has(failure, CertificateNotYetValidException.class)) {
      return "the server's certificate is not valid yet: is the clock right?";
    }
    if (has(failure, CertPathBuilderException.class)
        || has(failure, CertPathValidatorException.class)) {
      return "the server's certificate is not trusted: if it is the right server, give its"
          + " certificate by --tls-ca FILE or URBI_TLS_CA";
    }
    if (has(failure, CertificateException.class)) {
      return "the server's certificate is for another name: " + message;
    }
    if (has(failure, SocketTimeoutException.class)) {
      return "no answer in TLS: does the server speak it?";
    }
    if (has(failure, EOFException.class)) {
      return "the server has closed the connection: does it speak TLS?";
    }
    if (message.contains("unrecognized")) {
      return "the server has not answered in TLS: it does not speak it, or has no place for"
          + " another client";
    }
    return "TLS failed: " + message;
  }

  private static boolean has(Throwable failure, Class<?> kind) {
    for (Throwable each = failure; each != null; each = each.getCause()) {
      if (kind.isInstance(each)) {
        return true;
      }
    }
    return false;
  }
}
