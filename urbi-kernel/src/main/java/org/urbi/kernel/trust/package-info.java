/** Who may do what. */
package org.urbi.kernel.trust;
