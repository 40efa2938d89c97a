//! What the control groups of the process leave: a container's limit, or a batch system's.

use std::path::Path;

/// The files of one version of control groups.
struct Version {
    root: &'static str,
    limit: &'static str,
    usage: &'static str,
    /// In `memory.stat`: the cache of files, which is given back when memory is short.
    cache: &'static str,
}

const FIRST: Version = Version {
    root: "/sys/fs/cgroup/memory",
    limit: "memory.limit_in_bytes",
    usage: "memory.usage_in_bytes",
    cache: "total_inactive_file",
};

const SECOND: Version = Version {
    root: "/sys/fs/cgroup",
    limit: "memory.max",
    usage: "memory.current",
    cache: "inactive_file",
};

/// The text of a file, if there is one.
pub type Read<'a> = &'a dyn Fn(&Path) -> Option<String>;

/// The bytes that every group leaves in which the process is; None where none has a limit.
pub fn left(read: Read<'_>) -> Option<f64> {
    let groups = read(Path::new("/proc/self/cgroup"))?;
    // Each line is a number, the controllers (none for the second version) and the group.
    let of_line = |line: &str| {
        let mut parts = line.splitn(3, ':').skip(1);
        let (controllers, group) = (parts.next()?, parts.next()?);
        match controllers {
            "" => SECOND.left(group, read),
            list if list.split(',').any(|name| name == "memory") => FIRST.left(group, read),
            _ => None,
        }
    };
    groups.lines().filter_map(of_line).reduce(f64::min)
}

impl Version {
    /// A group's limit holds for those within it. In a container the group's name may be the machine's own, of which only the root
    /// is there.
    fn left(&self, group: &str, read: Read<'_>) -> Option<f64> {
        let folder = Path::new(self.root).join(group.trim_start_matches('/'));
        let within = folder.ancestors().take_while(|f| f.starts_with(self.root));
        let leaves = within.filter_map(|folder| self.left_by(folder, read));
        leaves.reduce(f64::min)
    }

    /// What one group leaves.
    fn left_by(&self, folder: &Path, read: Read<'_>) -> Option<f64> {
        let of_file = |name: &str| number(&read(&folder.join(name))?);
        let (limit, usage) = (of_file(self.limit)?, of_file(self.usage)?);
        let stat = read(&folder.join("memory.stat")).unwrap_or_default();
        let cache = stat.lines().find_map(|line| line.strip_prefix(self.cache));
        let held = usage - cache.and_then(number).unwrap_or(0.0);
        Some((limit - held.max(0.0)).max(0.0))
    }
}

/// The first word, if it is a number.
pub fn number(text: &str) -> Option<f64> {
    text.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left where these are all the files.
    fn left_with(files: &[(&str, &str)]) -> Option<f64> {
        left(&|path| {
            let found = files.iter().find(|(name, _)| Path::new(name) == path);
            found.map(|(_, text)| text.to_string())
        })
    }

    const UNIFIED: (&str, &str) = ("/proc/self/cgroup", "0::/batch/job\n");

    #[test]
    fn second_version() {
        let job = [
            UNIFIED,
            ("/sys/fs/cgroup/batch/job/memory.max", "max\n"),
            ("/sys/fs/cgroup/batch/job/memory.current", "900\n"),
        ];
        assert_eq!(left_with(&job), None);
        // The limit of a group further up counts, and what is cached of files is free.
        let batch = [
            ("/sys/fs/cgroup/batch/memory.max", "2000\n"),
            ("/sys/fs/cgroup/batch/memory.current", "1500\n"),
            (
                "/sys/fs/cgroup/batch/memory.stat",
                "anon 1100\nactive_file 300\ninactive_file 100\n",
            ),
        ];
        assert_eq!(left_with(&[&job[..], &batch[..]].concat()), Some(600.0));
        // In a container's own view its group is the root.
        let own = [
            ("/proc/self/cgroup", "0::/\n"),
            ("/sys/fs/cgroup/memory.max", "2000"),
            ("/sys/fs/cgroup/memory.current", "2500"),
        ];
        assert_eq!(left_with(&own), Some(0.0));
    }

    #[test]
    fn first_version() {
        let files = [
            (
                "/proc/self/cgroup",
                "5:cpu,cpuacct:/docker/a\n4:memory:/docker/a\n0::/\n",
            ),
            // The group's name is the machine's; here it is the root.
            ("/sys/fs/cgroup/memory/memory.limit_in_bytes", "2147483648"),
            ("/sys/fs/cgroup/memory/memory.usage_in_bytes", "1073741824"),
            (
                "/sys/fs/cgroup/memory/memory.stat",
                "inactive_file 5\ntotal_inactive_file 24\n",
            ),
        ];
        assert_eq!(left_with(&files), Some(1073741848.0));
        assert_eq!(left_with(&files[..1]), None);
        assert_eq!(left_with(&[]), None);
    }
}
