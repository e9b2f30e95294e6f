package org.urbi.server.trust;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.cert.CertificateException;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateFactory;
import java.security.cert.CertificateNotYetValidException;
import java.security.cert.X509Certificate;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.ArrayList;
import java.util.Base64;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a server shows its clients by TLS: a certificate, those that vouch for it, and the private
 * key that proves that it is the server's own.
 *
 * @param chain the server's certificate comes first
 * @param warnings what is not as it should be, for people
 */
public record ServerIdentity(List<X509Certificate> chain, PrivateKey key, List<String> warnings) {
  private static final Pattern KEY =
      Pattern.compile("-----BEGIN PRIVATE KEY-----(.*?)-----END PRIVATE KEY-----", Pattern.DOTALL);

  private static final Set<PosixFilePermission> OTHERS =
      EnumSet.of(
          PosixFilePermission.GROUP_READ,
          PosixFilePermission.GROUP_WRITE,
          PosixFilePermission.OTHERS_READ,
          PosixFilePermission.OTHERS_WRITE);

  /**
   * Reads the two files, in PEM.
   *
   * @throws IOException if one of them cannot be read or makes no sense, or they do not belong
   *     together; the message says what is wrong
   */
  public static ServerIdentity read(Path certificateFile, Path keyFile) throws IOException {
    List<X509Certificate> chain = certificates(certificateFile);
    PrivateKey key = key(keyFile);
    if (!fits(key, chain.getFirst())) {
      throw new IOException(
          "the key in " + keyFile + " does not fit the certificate in " + certificateFile);
    }
    List<String> warnings = new ArrayList<>();
    try {
      chain.getFirst().checkValidity();
    } catch (CertificateExpiredException e) {
      warnings.add(
          "the certificate in "
              + certificateFile
              + " has expired, clients will refuse it: it was valid until "
              + chain.getFirst().getNotAfter().toInstant());
    } catch (CertificateNotYetValidException e) {
      warnings.add(
          "the certificate in "
              + certificateFile
              + " is not valid yet, clients will refuse it before "
              + chain.getFirst().getNotBefore().toInstant());
    }
    if (isOpenToOthers(keyFile)) {
      warnings.add(keyFile + " can be read or written by others: chmod 600 " + keyFile);
    }
    return new ServerIdentity(chain, key, warnings);
  }

  private static boolean isOpenToOthers(Path file) throws IOException {
    PosixFileAttributeView posix =
        Files.getFileAttributeView(file, PosixFileAttributeView.class, new LinkOption[0]);
    return posix != null
        && posix.readAttributes().permissions().stream().anyMatch(OTHERS::contains);
  }

  private static List<X509Certificate> certificates(Path file) throws IOException {
    try {
      InputStream in = new ByteArrayInputStream(read(file));
      List<X509Certificate> chain =
          CertificateFactory.getInstance("X.509").generateCertificates(in).stream()
              .map(X509Certificate.class::cast)
              .toList();
      if (!chain.isEmpty()) {
        return chain;
      }
    } catch (CertificateException e) {
      throw new IOException("no certificate in PEM: " + file, e);
    }
    throw new IOException("no certificate in PEM: " + file);
  }

  private static byte[] read(Path file) throws IOException {
    try {
      return Files.readAllBytes(file);
    } catch (NoSuchFileException e) {
      throw new IOException("no such file: " + file, e);
    } catch (IOException e) {
      throw new IOException("cannot read " + file, e);
    }
  }

  private static PrivateKey key(Path file) throws IOException {
    String text = new String(read(file), StandardCharsets.ISO_8859_1);
    Matcher key = KEY.matcher(text);
    if (key.find()) {
      try {
        return decode(Base64.getMimeDecoder().decode(key.group(1)));
      } catch (IllegalArgumentException | GeneralSecurityException e) {
        throw new IOException("the private key is damaged: " + file, e);
      }
    }
    if (text.contains("ENCRYPTED")) {
      throw new IOException("the private key has a passphrase, which nobody could type: " + file);
    }
    if (text.contains("PRIVATE KEY-----")) {
      throw new IOException(
          "the private key is of an old form: openssl pkcs8 -topk8 -nocrypt -in "
              + file
              + " -out FILE makes it a new one");
    }
    throw new IOException("no private key in PEM: " + file);
  }

  private static PrivateKey decode(byte[] encoded) throws GeneralSecurityException {
    GeneralSecurityException last = null;
    for (String algorithm : List.of("EC", "RSA", "EdDSA")) {
      try {
        return KeyFactory.getInstance(algorithm).generatePrivate(new PKCS8EncodedKeySpec(encoded));
      } catch (GeneralSecurityException e) {
        last = e;
      }
    }
    throw last == null ? new GeneralSecurityException() : last;
  }

  /** Whether what the key has signed is what the certificate's owner has signed. */
  private static boolean fits(PrivateKey key, X509Certificate certificate) {
    String algorithm =
        switch (key.getAlgorithm()) {
          case "RSA" -> "SHA256withRSA";
          case "EC" -> "SHA256withECDSA";
          default -> "EdDSA";
        };
    try {
      Signature signature = Signature.getInstance(algorithm);
      signature.initSign(key);
      signature.update(certificate.getEncoded());
      byte[] signed = signature.sign();
      signature.initVerify(certificate.getPublicKey());
      signature.update(certificate.getEncoded());
      return signature.verify(signed);
    } catch (GeneralSecurityException e) {
      return false;
    }
  }
}
