package org.urbi.server.net;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.CertificateFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManagerFactory;
import org.urbi.server.tools.UrbiCertificate;
import org.urbi.server.trust.ServerIdentity;

/** A certificate and its key, in files. */
record TestIdentity(Path certificate, Path key) {
  /** Made by our own program. */
  static TestIdentity make(Path folder, String name, String... hosts) {
    String[] words = new String[hosts.length + 1];
    words[0] = folder.resolve(name).toString();
    System.arraycopy(hosts, 0, words, 1, hosts.length);
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    if (UrbiCertificate.run(words, nowhere, System.err) != 0) {
      throw new IllegalStateException("no certificate");
    }
    return new TestIdentity(folder.resolve(name + ".crt"), folder.resolve(name + ".key"));
  }

  /** Of 2020. */
  static TestIdentity expired(Path folder) throws IOException {
    TestIdentity made =
        new TestIdentity(folder.resolve("expired.crt"), folder.resolve("expired.key"));
    for (Path file : new Path[] {made.certificate, made.key}) {
      try (InputStream in = TestIdentity.class.getResourceAsStream(file.getFileName().toString())) {
        Files.copy(in, file);
      }
      Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
    }
    return made;
  }

  ServerIdentity read() throws IOException {
    return ServerIdentity.read(certificate, key);
  }

  /** A socket that speaks TLS with a server of this identity, when the handshake is over. */
  SSLSocket secure(Socket plain) throws IOException, GeneralSecurityException {
    KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
    store.load(null, null);
    try (var in = Files.newInputStream(certificate)) {
      store.setCertificateEntry(
          "own", CertificateFactory.getInstance("X.509").generateCertificate(in));
    }
    TrustManagerFactory trust =
        TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
    trust.init(store);
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(null, trust.getTrustManagers(), null);
    SSLSocket tls =
        (SSLSocket)
            context
                .getSocketFactory()
                .createSocket(plain, "localhost", plain.getPort(), /* autoClose= */ true);
    tls.startHandshake();
    return tls;
  }
}
