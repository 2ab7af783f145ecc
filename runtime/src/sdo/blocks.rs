//! What the server does in block transfers.

use super::{
    block_download::BlockDownload,
    block_upload::{check_block_size, BlockUpload},
    outgoing::Outgoing,
    server::{Answer, State},
    Server,
};
use crate::{
    od::{self, Device, Services},
    wire::sdo::{BlockSegment, Response},
    AbortCode, Address, Instant,
};

/// On what terms a client reads in blocks.
#[derive(Clone, Copy)]
pub(super) struct Terms {
    pub(super) crc: bool,
    pub(super) block_size: u8,
    pub(super) threshold: u8,
}

impl<B: AsRef<[u8]> + AsMut<[u8]>> Server<B> {
    /// `C0` to `C6`: from any state to `BlockDownload`.
    pub(super) fn block_download<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        address: Address,
        size: Option<u32>,
        crc: bool,
    ) -> Result<Answer, AbortCode> {
        let download = BlockDownload::begin(device, self.buffer.as_ref().len(), address, size, crc)?;
        self.enter(now, State::BlockDownload(download));
        let block_size = download.block_size();
        let response = Response::BlockDownloadInitiate {
            address,
            crc,
            block_size,
        };
        Ok(Answer::Response(response.emit()))
    }

    /// `01` to `FF`: stays in `BlockDownload`, but for an abort.
    #[inline(never)]
    pub(super) fn block_segment<D: Device>(&mut self, now: Instant, device: &mut D, bytes: [u8; 8]) -> Answer {
        let State::BlockDownload(download) = &mut self.state else {
            return Answer::Nothing;
        };
        let segment = BlockSegment::parse(bytes);
        if segment.is_abort() {
            self.reset();
            return Answer::Nothing;
        }
        let block_size = download.block_size();
        let taken = download.segment(device, self.buffer.as_mut(), segment);
        self.wait(now);
        match taken {
            Ok(None) => Answer::Nothing,
            Ok(Some(sequence)) => Answer::Response(Response::BlockDownloadAcknowledge { sequence, block_size }.emit()),
            Err(code) => Answer::Response(self.refuse(self.address(), code)),
        }
    }

    /// `C1` to `DD`: from `BlockDownload` to `Idle`.
    pub(super) fn block_download_end<D: Device>(
        &mut self,
        device: &mut D,
        services: &mut impl Services,
        unused: u8,
        crc: u16,
    ) -> Result<Answer, AbortCode> {
        let State::BlockDownload(download) = &self.state else {
            return Err(AbortCode::UNKNOWN_COMMAND);
        };
        download.end(device, services, self.buffer.as_ref(), unused, crc)?;
        self.reset();
        Ok(Answer::Response(Response::BlockDownloadEnd.emit()))
    }

    /// `A0` or `A4`: from any state to `BlockUpload`, or as `40` if the client would rather have it so.
    pub(super) fn block_upload<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        address: Address,
        terms: Terms,
    ) -> Result<Answer, AbortCode> {
        check_block_size(terms.block_size)?;
        let entry = od::readable(device, address)?;
        let outgoing = Outgoing::begin(device, self.buffer.as_mut(), entry, terms.crc)?;
        if terms.threshold != 0 && outgoing.size() <= usize::from(terms.threshold) {
            return Ok(Answer::Response(self.begin_upload(now, device, outgoing)));
        }
        let upload = BlockUpload::begin(outgoing, terms.block_size);
        self.enter(now, State::BlockUpload(upload));
        let (crc, size) = (terms.crc, outgoing.announced());
        Ok(Answer::Response(
            Response::BlockUploadInitiate { address, crc, size }.emit(),
        ))
    }

    /// `A3`: stays in `BlockUpload`.
    pub(super) fn block_upload_start(&mut self) -> Result<Answer, AbortCode> {
        let State::BlockUpload(upload) = &mut self.state else {
            return Err(AbortCode::UNKNOWN_COMMAND);
        };
        upload.start()?;
        self.due = Instant::NEVER;
        Ok(Answer::Block)
    }

    /// `A2`: stays in `BlockUpload`.
    pub(super) fn block_upload_acknowledge(
        &mut self,
        now: Instant,
        sequence: u8,
        block_size: u8,
    ) -> Result<Answer, AbortCode> {
        let State::BlockUpload(upload) = &mut self.state else {
            return Err(AbortCode::UNKNOWN_COMMAND);
        };
        if let Some(end) = upload.acknowledge(sequence, block_size)? {
            self.wait(now);
            return Ok(Answer::Response(end));
        }
        self.due = Instant::NEVER;
        Ok(Answer::Block)
    }

    /// `A1`: from `BlockUpload` to `Idle`.
    pub(super) fn block_upload_end(&mut self) -> Result<Answer, AbortCode> {
        let State::BlockUpload(upload) = &self.state else {
            return Err(AbortCode::UNKNOWN_COMMAND);
        };
        upload.finish()?;
        self.reset();
        Ok(Answer::Nothing)
    }
}
